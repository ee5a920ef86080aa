import { mapsOf } from "../../kit/locus/set-m";
import { Fitted } from "../../kit/picture/fitted";
import { onCircle } from "./walk";

const MAPS = mapsOf(onCircle(0.68, 66));

export const Thumb = () => <Fitted of={MAPS} />;
