/** What the page says when files and pasted text are opened. */
import { counted } from "#format/plural";

export const systemNumber = (number: number) => `System ${number}`;
export const thisFileContainsSystems = (count: number) => `This file contains ${count} systems. Choose one.`;
export const openAs = "Open as";
export const as = "As A";
export const shapeMorphStartsWith = "The shape the morph starts with";
export const asB = "As B";
export const shapeMorphEndsWith = "The shape the morph ends with";
export const asBoth = "As both";
export const atBothEnds = "At both ends";
export const searchByName = "Search by name";
export const showingSearchByName = (count: number, of: number) =>
  `Showing ${count} of ${of}. Search by name to find the others.`;
export const foundCount = (count: number) => `${count} found`;
export const noSystemHasName = "No system has a name like that.";
export const statesNote = (count: number) => counted(count, "state", "states");
export const objectsNote = (count: number) => counted(count, "object", "objects");
export const inSpace = (note: string) => `space, ${note}`;

export const seemsToCutOff = (cutAfter: string) =>
  `it seems to be cut off after “${cutAfter}”. Copy all of it.`;
export const openedPastedLink = "Opened the pasted link.";
export const pastedLinkCannotOpened = (problem: string) => `The pasted link cannot be opened: ${problem}`;
export const workUnchanged = (why: string | number) => `${why} Your work is unchanged.`;
export const fileFailed = (name: string, problem: string) => `${name}: ${problem} Your work is unchanged.`;
export const andMore = (more: number) => ` and ${more} more`;
export const notOpened = (names: string, more: string) =>
  `Not opened: ${names}${more}. Open each one separately.`;
export const wholeDocument = (name: string) => `${name} contains a whole document. Open it separately.`;
export const severalFiles = (count: number) => `${count} files`;
export const fileLargerThan256 = "The file is larger than 256 MB, so Frond cannot open it.";
export const fileEmptyChooseAnother = "The file is empty. Choose another.";
export const openedDocumentFrom = (name: string) => `Opened the document from ${name}.`;
export const undoable = (said: string) => `${said} Undo brings back your previous work.`;
export const maps = "Maps";
export const viewNotKept = "Its view is not kept, because it is turned: the whole shape is in view instead.";
export const coloursKept = "Its colours are kept.";
export const cannotOpen = (name: string, problem: string) =>
  `${name} cannot be opened: ${problem} Your work is unchanged.`;

export const nowShape = "is now shape A";
export const nowShapeB = "is now shape B";
export const nowBothShapes = "is now both shapes";
export const mapAndStateCount = (maps: number, states: number) =>
  `${counted(maps, "map", "maps")} in ${counted(states, "state", "states")}`;
export const mapCount = (count: number) => counted(count, "map", "maps");
export const taken = (name: string, place: string, maps: string, said: string) =>
  `${name} ${place}, with ${maps}. ${said}`;
export const openAsBInstead = "Open as B instead";

export const frondCannotOpenPasted =
  "Frond cannot open the pasted text. You can paste a link to a Frond document, maps (rows of numbers, Fractint, flames, JSON) or an outline (SVG, CSV, GeoJSON).";
export const pastedTextLongerThan =
  "The pasted text is longer than 16 million characters. Save it as a file and open that.";
export const pastedOutline = "Pasted outline";
export const pastedMaps = "Pasted maps";
export const pastedAnimation = "Pasted animation";

export const recognizedAs = (other: string) => `This is ${other}`;
export const frondDoesNotRead =
  "Frond does not read this type of file. It reads maps (.ifs, .flame, .aifs, JSON, tables), its own PNG, outlines (SVG, CSV, GeoJSON) and photos.";

export const weightsKeptChooseColour = "Its weights are kept: choose “Colour by density” to see them.";
export const weightsNotKeptSpace = "Its weights are not kept: space draws the full shape.";
