import { Small } from "../../kit/picture/small";
import { CubeSquare } from "./cube-square";

export function Thumb() {
  return (
    <Small>
      <CubeSquare cube={{ dimensions: 2, parts: 2 }} letters={2} point={[0.62, 0.3]} label={null} />
    </Small>
  );
}
