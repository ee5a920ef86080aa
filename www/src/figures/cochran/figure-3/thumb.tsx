import { useMemo } from "preact/hooks";
import { arrowhead } from "../graphs/arrowhead";
import { FROM_CORNER, SpaceView } from "./space-curve";

export function Thumb() {
  const points = useMemo(() => arrowhead(5), []);
  return <SpaceView points={points} eye={FROM_CORNER} shadows label={null} />;
}
