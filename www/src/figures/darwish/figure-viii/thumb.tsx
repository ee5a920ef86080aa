import { TREE, TREE_VIEW } from "../space/small-tree";
import { SpaceDots } from "../space/space-dots";

/** From another side. */
const ASIDE = { ...TREE_VIEW, turn: 2.1, tilt: 0.35 };

export const Thumb = () => <SpaceDots maps={TREE} view={ASIDE} />;
