import { barnsley } from "../../kit/connectedness/barnsley";
import { Rows } from "../../kit/connectedness/barnsley-rows";

export function Thumb() {
  return <Rows rounds={barnsley(0.47, 6)} r={0.47} bare />;
}
