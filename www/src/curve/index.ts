/** Closed curves in place of systems: the panel of their morph, their shelf in galleries, and what is said of them. */
export { CurvePart } from "./Part";
export { Shelf } from "./Shelf";
