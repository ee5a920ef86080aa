/** What is said of shapes of several states. */
import { counted, plural } from "#format/plural";

export const whatKnownAboutEach = "What is known about each state";
export const inOnePieceAt =
  "It is in one piece at every moment of this path: its pieces share points that never part.";
export const moreStates = (count: number) => `… and ${count} more.`;

export const states = "States";
export const state = "State";
export const mapsOfState = (number: number, x: string, y: string) =>
  `maps of state ${number}, at (${x}, ${y})`;
export const copiesState = "Copies state";
export const mapNamed = (number: number, name: string) => `Map ${number}, ${name}`;
export const duplicate = "Duplicate";
export const remove = "Remove";
export const addState = "Add a state";
export const removeLastState = "Remove the last state";

export const andOthers = ", and others";
export const openStates = (names: string) =>
  `Its own pieces are connected, but some are copies of state ${names}, which may not be. So it stays open: other pieces nearby may connect what is in pieces itself.`;
export const pairedStates = (count: number) =>
  `During the morph there are ${count} states, each pairing a state of A with one of B.`;

export const twoShapes = "The two shapes";
export const swapped = (a: string, b: string) => `Swapped: from ${a} to ${b}.`;
export const statesOf = (shape: string) => `The states of ${shape}`;
export const saveThisShape = "Save this shape";
export const documentWithBothShapes =
  "The document with both shapes, their states and maps. Frond can open it again";
export const saveAsJson = "Save as JSON";
export const saveAsAifs = "Save as AIFS, for IFStile";
export const editStates = (shape: string) => `Edit the states of ${shape}`;
export const moreFor = (shape: string) => `More for shape ${shape}`;
export const chooseAnother = "Choose another …";
export const isKept = (name: string) => `${name} is saved. Find it in the gallery under Yours.`;
export const alsoAs = (shape: string) => `Use as ${shape} too`;
export const bothShapes = (name: string) => `${name} is now both shapes.`;
export const shapesSeveralStates = "Shapes of several states";
export const bothEndsSameShape =
  "Both ends are the same shape. Choose another for one of them to get a morph.";
export const eachStateMadeCopies =
  "Each state is made of copies of states. During the morph, each map of a state becomes a map of another, and so do the states they copy. The path runs straight across the locus below.";
export const bothOutlinesSoThey = "Both are outlines, so they can morph as closed curves.";
export const asClosedCurves = "As closed curves";
export const provedFernFrondStays = "Proved: the fern “Frond” stays in one piece along the whole path.";
export const useFrond = "Use “Frond”";
export const provedBlendedEntryBy =
  "Proved: blended entry by entry, it stays in one piece along the whole path.";
export const blendEntryByEntry = "Blend entry by entry";
export const byEq6 = "By eq. 6";
export const bySignsAnglesAs = "By the signs of the angles, as in the paper";
export const left = "Left";
export const allCounterClockwise = "All counter-clockwise";
export const right = "Right";
export const allClockwise = "All clockwise";
export const halfTurns = "Half turns";
export const byRotation = "By rotation";
export const polarEachMapRotates =
  "Polar: each map rotates and stretches separately, so pieces keep their size";
export const entryByEntry = "Entry by entry";
export const linearMatrixEntriesBlended =
  "Linear: the matrix entries are blended, so ends that meet stay together";
export const map = "Map";
export const oneColourForEach = "One colour for each map of the shape";
export const oneColourForEachState = "One colour for each state that is copied after three maps";
export const plain = "Plain";
export const oneColour = "One colour";
export const motionAndColour = "Motion and colour";
export const blendMaps = "Blend maps";
export const colourBy = "Colour by";

export const theyMorphIntoShapes =
  "They morph into shapes of maps and into each other. Into outlines they morph only edge by edge.";
export const otherShapeStaysAnd = "The other shape stays, and the morph runs between both.";
export const shapeNow = (shape: string, name: string) => `Shape ${shape} is now ${name}.`;
export const aboutShelf = (morphs: string) =>
  `Graph-directed: each state is made of copies of states. ${morphs}`;
export const notLoaded = (problem: string) => `The shapes could not be loaded: ${problem}`;

export const edgeByEdge = (name: string) => `${name}, edge by edge`;
export const edgeStates = (name: string) =>
  `${name}, each edge a state or a segment. A fern can turn into it in one piece.`;

export const documentFrondUnderDirected =
  "A document of Frond: under `directed`, two graph-directed shapes. Each state is the union of copies of states, and the first state is the shape. `from` is the state that is copied, counted from 0. Maps are [a, b, c, d, e, f]: x' = a x + b y + e, y' = c x + d y + f; y points up. `now` is the system at the moment t.";

export const locusOverUTo =
  "Locus over u, to the right, and v, upwards, from −1 to 2: pale where the shape stays in one piece, dark where it is in pieces. ";
export const pathRunsStraightFrom = "The path runs straight from A at (0, 0) to B at (1, 1).";
export const locusCoarseBecauseEach =
  "The locus is coarse, because each sample takes long for shapes with so many maps. Frond still checks every moment that the picture shows.";

export const notSaved = (problem: string) => `The shapes could not be saved: ${problem}`;

export const statesAnd = (count: number, words: string) => `${count} states, ${words}`;
export const stateCount = (count: number) => `${count} states`;
export const assuming = (assumption: string) => `, if ${assumption} and so on`;
export const provedThroughout = (assuming: string) =>
  `The shape is in one piece at every moment of the path, proved${assuming}: its pieces share points that never part.`;
export const gapsAtMost = (gap: string, moments: number) =>
  `At every moment of the path, gaps between its pieces, and between theirs, are at most ${gap} of their size. Frond checked ${moments} moments and bounded the changes between them.`;
export const fallsApart = (place: string, source: string) =>
  `It falls apart on this path: at ${place} it is in pieces, ${source}.`;
export const noProofPast = (place: string) =>
  `There is no proof that it stays in one piece: the search fails at ${place}.`;
export const frondFoundNoProof = "Frond found no proof for the whole path in the time available.";
export const searchingForProofFor = "Searching for a proof for the whole path …";

export const sharedPoints = (points: number, first: string, second: string) =>
  `Its pieces share ${plural(points, { one: "a point", other: `${points} points` })}, checked without rounding. Maps ${first} reach the first one, and so do maps ${second}. All states that it is made of are connected in the same manner, so it is in one piece.`;
export const ifDecimals = (assumption: string, more: string) =>
  `It would be proved to be in one piece if its decimals stood for the numbers nearby: ${assumption}${more}.`;
export const neverReturn = (states: readonly string[]) =>
  plural(states.length, {
    one: `State ${states[0]} never comes back to itself: it is only a union of copies of other states. To make it a fractal of its own, let a map copy it, or copy a state that contains it.`,
    other: `States ${states.join(", ")} never come back to themselves: they are only unions of copies of other states. To make one a fractal of its own, let a map copy it, or copy a state that contains it.`,
  });
export const unused = (states: readonly string[]) =>
  plural(states.length, {
    one: `The shape is not made of state ${states[0]}, so that state is not visible. Let a map copy it, or remove it.`,
    other: `The shape is not made of states ${states.join(", ")}, so those states are not visible. Let a map copy them, or remove them.`,
  });
export const stateIs = (number: number, verdict: string) => `State ${number}: ${verdict}`;
export const shapeStateIs = (number: number, verdict: string) => `State ${number}, the shape: ${verdict}`;
export const halfTurnsOf = (count: number) =>
  `${counted(count, "map makes", "maps make")} exactly half a turn, which is equally short in either direction.`;
export const copiesOf = (count: number, state: number) =>
  `${counted(count, "copy", "copies")} of state ${state}`;
