import { CubeSquare } from "./cube-square";

export function Thumb() {
  return <CubeSquare cube={{ dimensions: 2, parts: 2 }} letters={2} point={[0.62, 0.3]} label={null} />;
}
