/** What is said of objects of space. */
import { counted } from "#format/plural";

export const shape = "Shape";
export const lightDirection = "Light direction";
export const custom2 = ", custom";
export const atMost = (dimension: string) => `at most ${dimension}`;
export const exactIfPiecesDo = "exact if its pieces do not overlap: all maps are similitudes";
export const affinityDimensionNotAll = "the affinity dimension: not all maps are similitudes";
export const atLeastInSuitable = "at least, in suitable coordinates";
export const counting = "Counting …";
export const count = "Count";
export const countedBoxes = (sizes: number, count: string) =>
  `counted: ${sizes} sizes of boxes, ${count} of the smallest`;

export const dimensionUnless = (dimension: string) => `dimension ${dimension}, unless pieces overlap`;
export const dimensionAtMost = (dimension: string) => `dimension at most ${dimension}`;
export const moreAboutObject = "More about the object";
export const maps = "Its maps";
export const facts = "Facts";
export const shadowOnPlane = "Shadow on a plane";

export const mapsUnchanged = (reason: string) => `${reason} The maps are unchanged.`;
export const mapNew = (number: number) => `Added map ${number}.`;
export const addMap = "Add a map";
export const backToDone = (name: string) => `Back to ${name}.`;
export const backTo = (name: string) => `Back to ${name}`;
export const mostMaps = (count: number) => `A shape has at most ${count} maps.`;

export const volumes = "Volumes";

export const newFrom = (axis: string, source: string) => `New ${axis} from ${source}`;
export const moveAlong = (axis: string) => `Move along ${axis}`;

export const naturalScene = "A natural scene";
export const hillsTreesWithBark =
  "Hills, trees with bark and leaves, ferns and clouds in evening light: all of them attractors, seen from the origin.";
export const fromPlane = (name: string) => `${name}, from the plane`;
export const shapeMorphToolAs = "The shape of the Morph tool, as a flat sheet at z = 0.";
export const objectCount = (count: number) => `${count} objects`;
export const whereTo = (name: string) => `Where should ${name} go?`;
export const shapesInSpace = "Shapes in space";
export const nothingHasChangedYet = "Nothing has changed yet.";
export const eachNothingButHandful = "Each is nothing but a handful of maps.";
export const placeAs = "Place it as";
export const newScene = "New scene";
export const startsOverWithWithout = "Starts over with it, without the morph and the timeline";
export const insteadOf = (name: string) => `Replaces ${name}`;
export const replace = "Replace";
export const add = "Add";
export const allStay = (count: number) => `all ${count} stay`;
export const replaceWhat = (name: string) => `Replace ${name}`;
export const oneLeaves = (name: string) => `${name} is removed`;
export const allLeave = (count: number) => `all ${count} are removed`;
export const backToShapes = "Back to the shapes";
export const firstChooseShapeThen = "First choose a shape. Then Frond asks what to do with the objects here.";
export const newSceneAllObjects = "A new scene. All objects are removed; Undo brings them back.";
export const replacesSelectedObjectWith =
  "It replaces the selected object, with the same transformation and colour.";
export const addedToScene = "It is added to the scene.";

export const objects = "Objects";
export const chooseAnother = (name: string) => `${name}. Choose another shape`;
export const addAnotherObjectTo = "Add another object to the scene";
export const mapsSpaceFromFractint =
  "Maps of space from Fractint and other programs. Maps of the plane open in Morph";
export const openIfs = "Open .ifs…";
export const currentParametersForFractint = "The current parameters, for Fractint and for Frond";
export const saveIfs = "Save .ifs";
export const selectedObject = "Selected object";
export const oneColourFor = (name: string) => `One colour for all of ${name}`;
export const oneColourForWhole = "One colour for the whole object";
export const useColoursMaps = "Use the colours of its maps";
export const remove = (name: string) => `Remove ${name}`;
export const isRemoved = (name: string) => `${name} is removed.`;

export const addedWithMaps = (name: string, count: number) => `${name} is added, with ${count} maps.`;
export const replacedWithMaps = (name: string, count: number) =>
  `${name} replaces the scene, with ${count} maps. Undo brings it back.`;
export const partOf = (name: string, number: number) => `${name} ${number}`;
export const aloneInObjects = (name: string, count: number) =>
  `${name} replaces the scene, in ${counted(count, "object", "objects")}. Undo brings it back.`;
export const objectNotSaved = (name: string, problem: string) => `${name} could not be saved: ${problem}`;

export const isAdded = (name: string) => `${name} is added.`;
export const replaces = (name: string, other: string) =>
  `${name} replaces ${other}, with the same transformation and colour.`;
export const isAlone = (name: string) => `${name} is the new scene. All other objects are removed.`;
export const thereLaterChangesUndo = "There are later changes. Undo, in the header, goes back step by step.";
export const undo = "Undo";
export const mostObjects = (count: number) => `A scene has at most ${count} objects. Remove some first.`;
export const cannotUse = (name: string, problem: string) => `${name} cannot be used: ${problem}`;

export const remainingThickness = "Remaining thickness";
export const enterNumberAbove0 = "Enter a number above 0, at most 1.";
export const largestNumber = (number: string, growing: string) =>
  `The largest number is ${number}. ${growing}`;

export const directionNeedsLength = "The direction needs a length.";
export const lightAlong = (axis: string) => `Parallel light along ${axis}: what is its shadow?`;
export const kept = "kept";
export const asViewed = "As viewed";
export const directionOf = (axis: string) => `Direction, ${axis}`;
export const shape2 = "a shape";
export const everyMapKeepsDirection =
  "Every map keeps the direction, so what it does to the shadow depends only on the shadow.";
export const morph3 = "Morph it";
export const bend = "Bend it";
export const frondFindsNoIfs = "Frond finds no IFS of the plane for this shadow from these maps.";
export const noDirectionKeptBy = "No direction is kept by all of its maps.";
export const keptAre = (directions: string) => `Directions kept: ${directions}.`;

export const shadowOf = (name: string) => `Shadow of ${name}`;
export const isShapeA = (name: string) => `${name} is now shape A.`;
export const shadowNotUsed = (problem: string) => `This shadow cannot be used there: ${problem}`;

export const flat = "flat";
export const volumesTimes = (factor: string, mirrored: string) => `volumes times ${factor}${mirrored}`;
export const mirroredAside = ", mirrored";
export const originalMaps =
  "The original maps, before the transformation. You can type formulas: 1/3, √3/2, cos 30°.";
export const originalMapsKeyed =
  "The original maps, before the transformation. You can type formulas: 1/3, √3/2, cos 30°. With a timeline, your changes become part of a keyframe at this moment.";
export const shadowAxes =
  "In the axes of the shadow: x to the right, y up, z along the light. They are left-handed, so these are the maps of a mirror image.";
export const firstOfMaps = (shown: number, count: number) => `The first ${shown} of ${count} maps.`;
export const shadowIs = (count: number) =>
  `This shadow is an IFS of the plane: ${counted(count, "map", "maps")}.`;
export const shadowIsOf = (count: number, different: number) =>
  `This shadow is an IFS of the plane: ${counted(count, "map", "maps")}, of which ${different} differ.`;
export const contractsBy = "Contracts by";
export const centre = "Centre";
export const radius = "Radius";
export const transformation = "Transformation";
export const inBoxes = "In boxes";
