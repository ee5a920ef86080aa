import { PYRAMID_AWAY, pyramid, pyramidMiddle } from "../space/shapes";
import { FROM_FAR } from "../space/small";
import { SpaceDots } from "../space/space-dots";

const MAPS = pyramid(pyramidMiddle(PYRAMID_AWAY));

export const Thumb = () => <SpaceDots maps={MAPS} view={FROM_FAR} />;
