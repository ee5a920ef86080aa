import { TREE, TREE_VIEW } from "../space/small-tree";
import { SpaceDots } from "../space/space-dots";

export const Thumb = () => <SpaceDots maps={TREE} view={TREE_VIEW} />;
