import { Pair } from "../../kit/picture/small";
import { Cell } from "./shuffle-matrix";

export function Thumb() {
  return (
    <Pair spaced>
      <Cell subject="square" chosen={{ kb: 0, ke: 3, superposed: false }} label={null} />
      <Cell subject="gasket" chosen={{ kb: 1, ke: 5, superposed: true }} label={null} />
    </Pair>
  );
}
