import { Small } from "../../kit/picture/small";
import { Curve } from "../lesson-18/curve";
import { LEVEL, tent } from "./hill";

export const Thumb = () => (
  <Small shape={400 / 250}>
    <Curve curve={tent(LEVEL)} label={null} />
  </Small>
);
