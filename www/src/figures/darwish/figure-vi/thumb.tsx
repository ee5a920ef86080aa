import { about3, turns3 } from "#geometry/maps/affine3";
import { PYRAMID_AWAY, pyramid } from "../space/shapes";
import { FROM_FAR, turnedHalves } from "../space/small";
import { SpaceDots } from "../space/space-dots";

const MIDDLE = [PYRAMID_AWAY, 0, 0] as const;
const MAPS = turnedHalves(pyramid([...MIDDLE]), about3(turns3([0, 0.35, 0.7]), [...MIDDLE]));

export const Thumb = () => <SpaceDots maps={MAPS} view={FROM_FAR} />;
