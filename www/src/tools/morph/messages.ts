/** What the tool Morph says beside its parts. */

export const byRotation = "By rotation";
export const polarEachMapRotates =
  "Polar: each map rotates and stretches separately, so pieces keep their size";
export const entryByEntry = "Entry by entry";
export const linearMatrixEntriesBlended =
  "Linear: the matrix entries are blended, so pieces shrink and flatten halfway";
export const map = "Map";
export const oneColourForEach = "One colour for each of the largest copies";
export const address = "Address";
export const shadeForEachCopy = "A shade for each copy of a copy";
export const density = "Density";
export const brighterWhereMorePoints = "Brighter where more points fall";
export const motionAndColour = "Motion and colour";
export const blendMaps = "Blend maps";
export const showsBothWaysTo = "Shows both ways to blend the maps at the same moment";
export const compareBothSideBy = "Compare both side by side";
export const colourBy = "Colour by";
export const applyMapsToPoint = "Apply the maps to a point one by one, or read its address";
export const stopFollowingPoint = "Stop following the point";
export const followPoint = "Follow a point";

export const shapesAndPicture = "Shapes and picture";
export const pathWithPointFocused = "Path, with a point focused";
export const moveBy001 = "Move by 0.01 (Shift: finer, Alt: coarser)";
export const addWaypoint = "Add a waypoint";
export const enter = "Enter";
export const removeWaypoint = "Remove the waypoint";
export const deleteLabel = "Delete";
export const outlineMapFocusedTab = "Outline of a map, focused (Tab)";
export const selectAndMoveShift = "Select and move it (Shift: finer)";
export const select = "Select it";
export const locusFocused = "Locus, focused";
export const moveCrossShiftFiner = "Move the cross (Shift: finer, Alt: coarser)";
export const zoomInZoomOut = "Zoom in, zoom out, reset";
export const showShapeAtCross = "Show the shape at the cross";
export const makeWaypoint = "Make it a waypoint";
export const followingPoint = "Following a point";
export const applyMapWithThis = "Apply the map with this number";
export const oneStepBack = "One step back";
export const backspace = "Backspace";
export const movePointFocusedShift = "Move the point, focused (Shift: finer)";
export const editMaps = "Edit the maps";
export const moveOrRotateWhole = "Move or rotate the whole shape";
export const removeSelectedMap = "Remove the selected map";
export const swapPictureAndLocus = "Swap picture and locus";
export const locusOnWholeScreen = "Locus on the whole screen";
export const followPointMapBy = "Follow a point map by map, or stop";
export const describePicture = "Describe the picture";

export const morph = "The morph";
export const oneClosedCurve = "one closed curve";
export const fromTo = (a: string, b: string) => `${a} to ${b}`;

export const otherPaths = "Other paths";
export const thisPathFallsApart = "This path falls apart.";

export const fromToAt = (a: string, b: string, t: string) => `${a} to ${b} at ${t}`;

export const morph2 = "Morph";
export const frondMorphOneFractal = "Frond: morph one fractal into another";
export const shapesAndPath = "Shapes and path";
