import { useState } from "preact/hooks";

let next = 0;

/** An id that no other widget has, in however many places of the page widgets are drawn. */
export function useOwnId(kind: string): string {
  const [id] = useState(() => `${kind}-${++next}`);
  return id;
}
