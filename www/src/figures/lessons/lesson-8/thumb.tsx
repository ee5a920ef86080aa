import { mapsOf } from "../../kit/locus/set-m";
import { Fitted } from "../../kit/picture/fitted";

const TAME = mapsOf([0.3, 0.6]);

export const Thumb = () => <Fitted of={TAME} />;
