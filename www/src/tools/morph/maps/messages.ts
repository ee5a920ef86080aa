/** What the editor of maps says. */

export const yourShapes = "Your shapes";
export const noneYet = "none yet";
export const saveShapeAndWork =
  "Save a shape and work on a copy, or open one you saved. This browser stores them. Undo reverts the edits.";
export const save = "Save";
export const saveAndContinueWith = "Save it and continue with a copy";
export const duplicate = "Duplicate";
export const newLabel = "New";
export const isKept = (name: string) => `${name} is saved.`;
export const keptAndEdited = (name: string, copy: string) => `${name} is saved. You are now editing ${copy}.`;
export const nowEdited = (name: string) => `You are now editing ${name}.`;

export const followsShape = "follows the shape";
export const unitSquare = "unit square";
export const frameOutlines = "Frame of the outlines";
export const frame = "Frame";
export const fixed = "Fixed";
export const followsShape2 = "Follows the shape";
export const left = "Left";
export const bottom = "Bottom";
export const width = "Width";
export const height = "Height";
export const unitSquare2 = "Unit square";
export const aroundShape = "Around the shape";

export const mapsOfShape = (shape: string) => `Maps of shape ${shape}`;
export const mapsOf = (shape: string) => `Maps of ${shape}`;
export const done = "Done";
export const nameOfShape = (shape: string) => `Name of shape ${shape}`;
export const shapeRenamed = (shape: string, name: string) => `Shape ${shape} is now called ${name}.`;
export const edit = "Edit";
export const mapByMap = "Map by map";
export const wholeShape = "Whole shape";
export const mapsUnchanged = (reason: string) => `${reason} The maps are unchanged.`;
export const mapMirrored = (number: number) => `Map ${number} is mirrored.`;
export const mirrorThisMap = "Mirror this map";
export const dragOutlinesOnPicture =
  "Drag the outlines on the picture, or type numbers or formulas: 1/3, √3/2, (1 + sqrt 5)/2, cos 30°.";
export const mapFormat = "Map format";
export const turnStretchMove = "Turn, stretch, move";
export const sixNumbers = "Six numbers";
export const snapToCornersEdges = "Snap to corners, edges and angles (hold Alt to switch)";
export const shapeSingleMapPoint = "The shape of a single map is a point. Add another map to see more.";
export const mapNew = (number: number) => `Added map ${number}.`;
export const addMap = "Add a map";
export const thisShapeNotFrom = "This shape is not from the gallery";
export const backToOrigin = (name: string) => `Back to ${name}`;
export const backToOriginDone = (name: string) => `Back to ${name}.`;
export const reset = "Reset";

export const turn = "Turn";
export const slant = "Slant";
export const stretchAcross = "Stretch across";
export const stretchUp = "Stretch up";
export const moveAcross = "Move across";
export const moveUp = "Move up";
export const newXFromX = "New x from x";
export const newXFromY = "New x from y";
export const newYFromX = "New y from x";
export const newYFromY = "New y from y";

export const weights = "Weights";
export const custom = "custom";
export const byArea = "by area";
export const atLeastOneMap = "At least one map needs a weight above 0.";
export const howOftenChaosGame =
  "How often the chaos game picks each map, as a share of all picks. Weights change only the density of the points. The shape, its maps and its verdict stay the same. A map with weight 0 is never picked, so the density leaves its copies out.";
export const lessonOnWeights = "Lesson on weights";
export const weightOf = (number: number) => `Weight of map ${number}`;
export const allMapsHaveSame = "All maps have the same weight.";
export const equal = "Equal";
export const eachWeightProportionalTo =
  "Each weight is proportional to the area of its copy, so points fall evenly";
export const weightsByArea = (shape: string) => `The weights of ${shape} go by area again.`;
export const byArea2 = "By area";
export const weightsOnlyShowWhen = "Weights only show when the picture is coloured by density.";
export const nowDensity = (name: string) => `${name} is now coloured by density.`;
export const colourByDensity = "Colour by density";

export const dragShapeOnPicture =
  "Drag the shape on the picture, or type. This moves its maps’ parameters, so connectedness does not change, although less may be provable with rounded numbers. The path to the other shape changes.";
export const areas = "Areas";

export const thisOnlyMapShape = "This is the only map. A shape needs at least one.";
export const mapRemoved = (number: number) => `Map ${number} is removed.`;
export const undo = "Undo";

export const outlineIs =
  "Each outline shows what a map makes of the dashed frame. Moving the frame changes no map.";
export const outlineIsDrag =
  "Each outline shows what a map makes of the dashed frame. Moving the frame changes no map. Drag two of its corners on the picture, or type.";
export const fixedNow = "fixed";
