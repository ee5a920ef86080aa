/** What the picture and the controls on it say. */

export const objectsShadow = "The object’s shadow";

export const fitPictureToWindow = "Fit the picture to the window";
export const shapeAndPicture = "Shape and picture";
export const colourBy = (colours: string) => `Colour by ${colours}`;
export const gallery = "Gallery";

export const backTo = (a: string, b: string) => `Back to systems of maps: ${a} and ${b}.`;
export const backToSystemsMaps = "Back to systems of maps";

export const browserCouldNotCreate = "The browser could not create a canvas.";

export const partInPieces = (source: string) => `part of it is in pieces, ${source}`;

export const whatKnownAndWhy = "What is known, and why";

export const closeExplanation = "Close the explanation";

export const shapesMapsAsParallelograms = "The shape’s maps as parallelograms";
export const mapNumber = (number: number) => `Map ${number}`;
export const frameShape = "Frame of the shape";
export const fullShape = "The full shape";

export const gripOf = (name: string, does: string) => `${name}, ${does}: arrow keys, Shift for finer steps`;
export const turnerOf = (name: string) => `${name}, only turns it: arrow keys, Shift for finer steps`;

export const lowerLeft = "lower left";
export const upperRight = "upper right";
export const frameCorner = (corner: string) =>
  `Frame, ${corner} corner: arrow keys move it, Shift for finer steps`;
export const frameCornerAt = (corner: string, x: string, y: string) => `Frame, ${corner} corner: ${x}, ${y}`;

export const moves = "moves it";
export const firstSide = "first side";
export const secondSide = "second side";
export const turnsAndScales = "turns and scales it";

export const legend = "Legend";
export const noGapSeen = "no gap seen";
export const apartUnder = (apart: string, resolution: string) =>
  `${apart}; gap under ${resolution} of its size`;
export const partOfPale = (words: string, percent: number) => `${words} (${percent}% of the pale area)`;
export const apartGap = (aPART: string | number) => `${aPART}, gap`;
export const ofItsSize = "of its size";

export const whereStaysInOne = "Where it stays in one piece";
export const show = "Show";
export const gap = "Gap";
export const widthWidestGapBetween = "The width of the widest gap between pieces";
export const yesNo = "Yes / no";
export const onlyWhetherStaysIn = "Only whether it stays in one piece";

export const computingWhereStaysIn = "Computing where it stays in one piece";

export const auto = "Auto";
export const frondChoosesPathWith = "Frond chooses the path with the narrowest gap";
export const straight = "Straight";
export const turnStretchAndMove = "Turn, stretch and move together at the same pace";
export const drawn = "Drawn";
export const throughYourOwnWaypoints = "Through your own waypoints";
export const path = "Path";
export const kindPath = "Kind of path";
export const addWaypointAtCurrent = "Add a waypoint at the current picture";
export const addWaypoint = "Add waypoint";
export const waypointOf = (number: number, count: number) => `Waypoint ${number} of ${count}`;
export const turnAndStretchU = "turn and stretch, u";
export const moveV = "move, v";
export const stretchLeadW = "stretch lead, w";
export const addWaypointAfterThis = "Add a waypoint after this one";
export const removeThisWaypoint = "Remove this waypoint";

export const positionOnPath = "Position on the path";
export const placeOnPath = (percent: string, state: string) => `${percent} of the path, ${state}`;

export const fronds = "Frond’s";
export const custom = "custom";
export const coloursMaps = "Colours of the maps";
export const afterOkabeAndIto = "After Okabe and Ito: darker on a light background, lighter on a dark one";
export const custom2 = "Custom";
export const colourForEachMap = "A colour for each map";
export const publishedPalettesColourBlind =
  "The published palettes are colour-blind safe. Maps are numbered too. The link includes your choice.";

export const picture = "Picture";
export const byRotationPolar = "By rotation (polar)";
export const entryByEntryLinear = "Entry by entry (linear)";
export const theseMapsHaveNo = "These maps have no attractor: together they do not contract.";

export const thereNoPictureYet = "There is no picture yet.";

export const graphicsCardNotAvailable =
  "The graphics card is not available, so the processor draws the picture. To use the card, turn on hardware acceleration in the browser’s settings.";
export const rendererMissing = (problem: string) =>
  `The renderer could not be loaded (${problem}), so the processor draws the picture. Reload the page to try again.`;

export const deviceLost = (reason: string) =>
  `The graphics card stopped responding (${reason}). Frond has drawn the picture again.`;

export const chosenHandle = (name: string) => `${name}, chosen; arrow keys move it`;
export const onlyHandle = (name: string) => `${name}: arrow keys move it`;
export const pictureKeys = (what: string, more: string) =>
  `The ${what}. Arrow keys move it, plus and minus zoom, 0 fits it to the stage.${more}`;
export const curve = "curve";
export const attractor = "attractor";
export const describeKey = " D describes it.";
export const noGapTo = (noGap: string, resolution: string) =>
  `${noGap} (checked to ${resolution} of its size)`;
