/** What the document says: of links, of what is kept, and of parts of the page that have to be fetched. */
import { plural } from "#format/plural";

// Of links.
export const addressIsBehind = (why: string) => `The address no longer matches what you see. ${why}`;
export const linkCutOff = (after: string) =>
  `This link seems to be cut off after “${after}”. Ask for it again.`;
export const showsDefault = (why: string) => `${why} Frond shows its default shapes instead.`;
export const showsRest = (why: string) => `${why} Frond shows what is left of it.`;
export const showsDefaultSpace = (why: string) => `${why} Frond shows its default scene instead.`;

// Of parts of the page.
export const partNotFetched =
  "A part of Frond could not be fetched. Either you are offline or Frond was updated. Reload the page; the address keeps what you made.";
export const reload = "Reload";
export const curvesNotLoaded = (why: string) => `The code for closed curves could not be loaded: ${why}`;
export const bendsNotLoaded = (why: string) => `The code for deformations could not be loaded: ${why}`;
export const statesNotLoaded = (why: string) =>
  `The code for shapes of several states could not be loaded: ${why}`;

// Of shapes of one's own and of what the browser keeps.
export const tooManyShapes = (most: number) =>
  `You can keep up to ${plural(most, { one: "1 shape", other: `${most} shapes` })}. Remove one first.`;
export const nameIsEmpty = "Enter a name of at least one letter.";
export const shapesNotStored =
  "The browser did not store this shape, so it disappears when you close the page. The link still contains it.";
export const tooManyPinned = (most: number) =>
  `You can pin up to ${plural(most, { one: "1 item", other: `${most} items` })}. Unpin or remove one first.`;
export const noRoom =
  "The browser has no room left for Frond. Remove something from Recent, or save the link.";
export const newerFrond =
  "A newer version of Frond stored your work here. Reload the page to see it; the address keeps what you made.";
export const notStored =
  "The browser stores nothing for Frond, as in a private window. The address keeps what you made.";

// Of shapes.
export const mirroredGasket = "Mirrored gasket";
export const undo = "Undo";
export const replaced = (gone: string, there: string) => `${there} replaces ${gone}.`;
export const outlinesMorphIntoOutlines = (end: string, there: string, gone: string) =>
  `Outlines morph only into outlines, so ${end} is now ${there} instead of ${gone}.`;
export const aToB = (a: string, b: string) => `${a} to ${b}`;
export const notEdgeByEdge = (name: string, why: string) => `${name} cannot be morphed edge by edge: ${why}`;
export const morphEnded =
  "The morph has ended, because it belonged to the previous maps. Undo brings it back.";

// Of the picture that is bent.
export const pictureNotInLink = "The link does not contain the picture. Choose it again.";
export const sampleNotLoaded = "The sample picture could not be loaded. Choose a picture of your own.";
export const noCanvas = "This browser cannot draw on a canvas.";
export const sampleName = "Sample: ferns at dusk";
