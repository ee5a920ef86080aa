import { useMemo } from "preact/hooks";
import { heightsAlong, TOP } from "../graphs/arrowhead";
import type { Line } from "../graphs/profile";
import { Still } from "../graphs/still";

export function Thumb() {
  const lines = useMemo((): Line[] => [{ points: heightsAlong(5, TOP), colour: "ink", width: 1.25 }], []);
  return <Still lines={lines} t={[0, 1]} />;
}
