import { about3, turns3 } from "#geometry/maps/affine3";
import { PYRAMID_AWAY, pyramid, pyramidMiddle } from "../space/shapes";
import { FROM_FAR, turnedHalves } from "../space/small";
import { SpaceDots } from "../space/space-dots";

const MIDDLE = pyramidMiddle(PYRAMID_AWAY);
const MAPS = turnedHalves(pyramid(MIDDLE), about3(turns3([0, -0.79, -0.35]), MIDDLE));

export const Thumb = () => <SpaceDots maps={MAPS} view={FROM_FAR} />;
