import { useMemo } from "preact/hooks";
import { Small } from "../../kit/picture/small";
import { orbit, repeated, turning } from "./orbit";
import { Track } from "./track";

export function Thumb() {
  const points = useMemo(() => orbit(repeated(turning(0.9, 25), 30), [1, 0.3]), []);
  return (
    <Small shape={4 / 3}>
      <Track points={points} reach={1.3} label={null} />
    </Small>
  );
}
