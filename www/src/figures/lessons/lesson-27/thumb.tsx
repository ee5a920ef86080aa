import { Fitted } from "../../kit/picture/fitted";
import { LEAF, rounded } from "./rounded";

const MAPS = rounded(LEAF, 3);

export const Thumb = () => <Fitted of={MAPS} />;
