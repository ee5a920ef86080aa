import { PYRAMID_AWAY, pyramid } from "../space/shapes";
import { FROM_FAR } from "../space/small";
import { SpaceDots } from "../space/space-dots";

const MAPS = pyramid([PYRAMID_AWAY, 0, 0]);

export const Thumb = () => <SpaceDots maps={MAPS} view={FROM_FAR} />;
