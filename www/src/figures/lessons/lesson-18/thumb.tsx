import { Small } from "../../kit/picture/small";
import { Curve } from "./curve";

export const Thumb = () => (
  <Small shape={400 / 250}>
    <Curve curve={{ heights: [0, 0.7, 0.3, 0.9, 0.2], factors: [0.4, 0.4, 0.4, 0.4] }} label={null} />
  </Small>
);
