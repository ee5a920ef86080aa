import { turns3 } from "#geometry/maps/affine3";
import { triangle } from "../space/shapes";
import { ALONG_X, turnedHalves } from "../space/small";
import { SpaceDots } from "../space/space-dots";

const MAPS = turnedHalves(triangle("halves"), turns3([-0.49, 0.37, 2.69]));

export const Thumb = () => <SpaceDots maps={MAPS} view={{ ...ALONG_X, target: [0, -0.22, 0] }} />;
