import { triangle } from "../space/shapes";
import { FRONT } from "../space/small";
import { SpaceDots } from "../space/space-dots";

const MAPS = triangle("halves");

export const Thumb = () => <SpaceDots maps={MAPS} view={FRONT} />;
