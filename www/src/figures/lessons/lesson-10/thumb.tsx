import { Matching } from "./matching";

export function Thumb() {
  return <Matching matching={[1, 0, 2]} wide />;
}
