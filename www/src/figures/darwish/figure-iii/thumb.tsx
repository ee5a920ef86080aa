import { turns3 } from "#geometry/maps/affine3";
import { triangle } from "../space/shapes";
import { FRONT, turnedHalves } from "../space/small";
import { SpaceDots } from "../space/space-dots";

const MAPS = turnedHalves(triangle("halves"), turns3([-0.5, 0.4, -0.9]));

export const Thumb = () => <SpaceDots maps={MAPS} view={FRONT} />;
