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

// What the timeline says.

export const inPieces = "in pieces";
export const noAttractor = "no attractor";
export const notDecided = "not decided";
export const filmMorph = "Film of the morph";
export const pictureLoading = "picture loading";
export const atMoment = (words: string) => `At ${words}`;

export const time = "Time";
export const offPath = (percent: string) => `${percent}; the picture is off the path`;
export const searchingPath = (percent: string) => `${percent}; Frond is searching for a path`;
export const pictureOffPath = "picture off the path";
export const worstAt = (gap: string, percent: string) => `Widest gap: ${gap}, at ${percent}`;
export const timeInPercent = "Time in percent";
export const loopBackAndForth = "Loop back and forth";
export const speed = "Speed";

// What is said of the two shapes and their gallery.

export const twoShapes = "The two shapes";
export const swapped = (a: string, b: string) => `Swapped: from ${a} to ${b}.`;
export const editMapsOf = (shape: string) => `Edit the maps of ${shape}`;
export const moreFor = (shape: string) => `More for shape ${shape}`;
export const chooseAnother = "Choose another …";
export const newShape = "New shape …";
export const moveRotateOrScale = "Move, rotate or scale it";
export const mapsAsText = "Maps as text …";
export const saveThisShape = "Save this shape";
export const isKept = (name: string) => `${name} is saved. Find it in the gallery under Yours.`;
export const alsoAs = (shape: string) => `Use as ${shape} too`;
export const atBothEnds = (name: string) => `${name} is now both shapes.`;

export const shapeNow = (shape: string, name: string) => `Shape ${shape} is now ${name}.`;
export const shape = (shape: string) => `Shape ${shape}`;
export const eachMadeSmallerCopies = "Each is made of smaller copies of itself. You can edit its maps later.";
export const otherIsOutline = (shape: string, name: string) =>
  `Shape ${shape} is ${name}, an outline. Outlines morph only into outlines.`;
export const replacesOutline = (shape: string, system: string, outline: string) =>
  `These do not morph into outlines. If you choose one, shape ${shape} becomes ${system} instead of ${outline}.`;

export const newShape2 = "New shape";

export const staysInOnePiece = (other: string | number) => `Stays in one piece with ${other}`;
export const canStayInOne = (other: string | number) =>
  `Can stay in one piece with ${other}; Frond will look for the pairing`;
