import { useEffect, useState } from "preact/hooks";

/** So long after its last change, in milliseconds, a value is at rest. */
const REST_MS = 150;

/** A value as it was when it last rested: for what takes longer than a frame. */
export function useRested<T>(value: T): T {
  const [rested, setRested] = useState(value);
  useEffect(() => {
    const timer = setTimeout(() => setRested(() => value), REST_MS);
    return () => clearTimeout(timer);
  }, [value]);
  return rested;
}
