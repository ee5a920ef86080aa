import { Small } from "../../kit/picture/small";
import { Board } from "./board";
import { GOOD } from "./collage";

export function Thumb() {
  return (
    <Small shape={4 / 3}>
      <Board copies={GOOD} label={null} />
    </Small>
  );
}
