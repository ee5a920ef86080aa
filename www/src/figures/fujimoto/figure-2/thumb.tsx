import { Small } from "../../kit/picture/small";
import { pieceOf, rightGasket } from "../codes/addresses";
import { Steps } from "./address-steps";

export function Thumb() {
  return (
    <Small>
      <Steps
        r={0.55}
        depth={2}
        point={[0.5, 0]}
        here={[
          [0, 1],
          [1, 0],
        ].map((word) => pieceOf(rightGasket(0.55), word))}
        label={null}
      />
    </Small>
  );
}
