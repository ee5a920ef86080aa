import { turns3 } from "#geometry/maps/affine3";
import { triangle } from "../space/shapes";
import { FRONT, turnedHalves } from "../space/small";
import { SpaceDots } from "../space/space-dots";

const MAPS = turnedHalves(triangle("halves"), turns3([-0.54, -0.61, -0.42]));

export const Thumb = () => <SpaceDots maps={MAPS} view={FRONT} />;
