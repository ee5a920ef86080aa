import { PRINTED_MIDDLE, printedTriangle } from "../space/shapes";
import { ALONG_X } from "../space/small";
import { SpaceDots } from "../space/space-dots";

const MAPS = printedTriangle();

export const Thumb = () => <SpaceDots maps={MAPS} view={{ ...ALONG_X, target: PRINTED_MIDDLE }} />;
