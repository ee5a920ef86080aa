import { mapsOf } from "../../kit/locus/set-m";
import { Fitted } from "../../kit/picture/fitted";
import { onCircle } from "../lesson-25/walk";

const MAPS = mapsOf(onCircle(0.6, 88));

export const Thumb = () => <Fitted of={MAPS} />;
