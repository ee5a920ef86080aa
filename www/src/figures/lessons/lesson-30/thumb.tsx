import { useMemo } from "preact/hooks";
import { Small } from "../../kit/picture/small";
import { orbit, pushing, repeated } from "../lesson-14/orbit";
import { Track } from "../lesson-14/track";

export function Thumb() {
  const points = useMemo(() => orbit(repeated(pushing(0.6, 1.5), 12), [0, 1]), []);
  return (
    <Small shape={4 / 3}>
      <Track points={points} reach={1.05} middle={[0.13, 0.8]} label={null} />
    </Small>
  );
}
