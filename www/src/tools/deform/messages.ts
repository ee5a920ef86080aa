/** What the tool Deform says. */

export const map = "Map";
export const oneColourForEach = "One colour for each of the largest copies";
export const address = "Address";
export const shadeForEachCopy = "A shade for each copy of a copy";
export const density = "Density";
export const brighterWhereMorePoints = "Brighter where more points fall";
export const grid = "Grid";
export const coloursGridPassedOn = "Colours of the grid, passed on to all parts like the deformation";
export const copies = "Copies";
export const oneColourForAll = "One colour for all copies of an arc";
export const edges = "Edges";
export const coloursAlternateFromEdge = "Colours alternate from edge to edge";
export const plain = "Plain";
export const oneColour = "One colour";
export const colour = "Colour";
export const colourBy = "Colour by";
export const upperLeft = "Upper left";
export const upperRight = "Upper right";
export const lowerLeft = "Lower left";
export const lowerRight = "Lower right";
export const selectHandlesOnGrid = "Select handles on the grid to colour them one by one.";
export const selectedHandle = "The selected handle";
export const selectedHandles = (count: number) => `The ${count} selected handles`;
export const blendCorners = "Blend the corners";
export const howSmallPartsColoured = "How small parts are coloured";
export const localityColours = "Locality of colours";
export const tintKb = "tint kb";
export const roughnessColours = "Roughness of colours";
export const tintDelta = "tint delta";
export const detailColours = "Detail of colours";
export const allScalesTogether = "All scales together";

export const keyframe = "keyframe";
export const shapeAndPicture = "Shape and picture";
export const addKeyframe = "Add a keyframe";
export const time = "Time";
export const keyframeFocused = "Keyframe, focused";
export const moveInTimeShift = "Move in time (Shift: finer, Alt: coarser)";
export const toNextOne = "To the next one";
export const deleteLabel = "Delete it";
export const deleteLabel2 = "Delete";
export const handleGridFocused = "Handle of the grid, focused";
export const moveShiftCoarserAlt = "Move it (Shift: coarser, Alt: finer)";
export const toHandleBeforeOr = "To the handle before or after";
export const selectDeselect = "Select it, deselect it";
export const selectAll = "Select all";
export const reset = "Reset it";
export const nextOrPreviousDrag = "Next or previous drag mode: move, pull, select";
export const hideOrShowGrid = "Hide or show the grid";

export const deform = "Deform";
export const frondDeformFractalWith = "Frond: deform a fractal with a grid";
export const shapeAndGrid = "Shape and grid";
export const deformationGridCouldNot = "The deformation grid could not be loaded";

export const shapeSeveralStatesCannot =
  "A shape of several states cannot be deformed. You can film its morph.";
export const nothingMovesYetSingle =
  "Nothing moves yet: a single keyframe is a still picture. Choose a motion, or add another keyframe.";
export const useMotionSway = "Use the motion Sway";
export const deformation = "The deformation";

export const closedCurveHasNo =
  "A closed curve has no pieces that could rotate or come apart. It is deformed along its length, and agrees where two parts meet.";

export const off = "Off";
export const eachHandleMovesAlone = "Each handle moves alone";
export const leftRight = "Left/right";
export const mirroredHandleOnOther = "The mirrored handle on the other side moves too";
export const upDown = "Up/down";
export const mirroredHandleAboveOr = "The mirrored handle above or below moves too";
export const point = "Point";
export const handleAcrossCentreMoves = "The handle across the centre moves in the opposite direction";
export const resetAll = "Reset all";
export const showGrid = "Show grid";
export const mirror = "Mirror";
export const columns = "columns";
export const rows = "rows";
export const columns2 = "Columns";
export const rows2 = "Rows";
export const enterWholeNumber = "Enter a whole number.";

export const gridOf = (columns: number, rows: number) => `Grid of ${columns} by ${rows} handles`;

export const mostKeys = (count: number) =>
  `There are already ${count} keyframes, the limit. Go to one of them or remove one to deform the grid.`;

export const handleReset = "Handle reset.";
export const handlesReset = (count: number) => `${count} handles reset.`;
export const allHandlesReset = "All handles reset.";

export const move = "Move";
export const dragBesideHandlesTo = "Drag beside the handles to move the picture";
export const pull = "Pull";
export const dragAnywhereToPull = "Drag anywhere to pull the grid there. Or hold Alt";
export const select = "Select";
export const dragFrameToSelect = "Drag a frame to select the handles in it. Or hold Shift";
export const resetHandle = "Reset the handle";
export const resetSelectedHandles = "Reset the selected handles";
export const dragMode = "Drag mode";

export const noHandleSelectedClick = "No handle selected. Click one on the grid.";
export const movedRight = "Moved right";
export const movedUp = "Moved up";
export const selectedHandles2 = "Selected handles";
export const moreWithIt = (count: number) => `, and ${count} more with it`;

export const rowsCountFromBottom =
  "Rows count from the bottom. Arrow keys move the handle and all selected ones: by a hundredth of the grid, ";
export const withShiftByTenth =
  "with Shift by a tenth, with Alt by a thousandth. Page Down and Page Up, or the closing and the opening ";
export const bracketGoToNext =
  "bracket, go to the next and the previous handle; Control and an arrow go to the neighbour. Space selects or deselects it, Control and A selects all, ";
export const deleteResetsSelectionEscape = "Delete resets the selection, Escape clears it.";
export const allSelected = (count: number) => `All ${count} handles selected.`;
export const deselected = "deselected";
export const nothingSelected = "Nothing selected.";

export const columnAndRow = (column: number, row: number) => `Column ${column}, row ${row}`;
export const atRest = "at rest";
export const movedBy = (parts: string) => `moved ${parts}`;

export const handlesSelected = (count: number) => `${count} handles selected.`;

export const motion = "Motion";
export const ownKeys = (count: number) => `${count} custom keyframes`;
export const stillOneGridFor = "Still: one grid for all times.";
export const everyPartSwaysAbout = " Every part sways about its own stem.";
export const pressPlayToSee = " Press Play to see it.";
export const motionIs = (
  name: string,
  about: string,
  count: number,
  seconds: number,
  turns: string,
  hint: string,
) => `${name}: ${about}. ${count} keyframes in ${seconds} seconds.${turns}${hint}`;

export const yourPicture = "Your picture";
export const drawingSample = "Drawing the sample …";
export const pixels = (width: number, height: number) => `about ${width} × ${height} pixels`;
export const pictureFile = "Picture file";
export const choosePicture = "Choose a picture";
export const backToSample = "Back to the sample";
export const orDropOneOn =
  "Or drop one on the stage, or paste it. Your picture stays on this device: nothing is uploaded, and links do not contain it.";

export const nowOnStage = (name: string) => `${name} is on the stage.`;
export const sampleOnStage = "The sample is on the stage.";
export const noCanvas = "no canvas";

export const pictureOnStageUnchanged = "The picture on the stage is unchanged.";
export const isDrawing = (name: string, stays: string) =>
  `“${name}” is a drawing (SVG), not a picture made of pixels. Save it as PNG first. ${stays}`;
export const isOther = (name: string, what: string, stays: string) => `“${name}” is ${what} ${stays}`;
export const isUnknown = (name: string, stays: string) =>
  `Frond cannot read “${name}”. It reads PNG, JPEG, WebP, AVIF and GIF. ${stays}`;
export const isTooLarge = (name: string, size: string, most: number, stays: string) =>
  `“${name}” has ${size}. The limit is ${most} megapixels. Scale it down first. ${stays}`;
export const isDamaged = (name: string, stays: string) => `“${name}” is damaged or incomplete. ${stays}`;
export const picture = "Picture";

export const deformation2 = "Deformation";
export const howPartsRespond = "How the parts respond";
export const scales = "Scales";
export const allTogether = "All together";
export const sumAllScalesKb = "The sum of all scales, kb to ke";
export const smallestOnly = "Smallest only";
export const onlyLastShuffleDown = "Only the last shuffle, down to ke";
export const thisShowsLastSettings = "This shows the last settings that worked.";
export const locality = "Locality";
export const scatteredEveryPartResponds = "scattered: every part responds";
export const detail = "Detail";
export const fullShape = "the full shape";
export const smallestParts = "the smallest parts";
export const roughness = "Roughness";
export const text = "δ";
export const roughFrom = (roughness: string) =>
  `From ${roughness} on it is rough: the response shrinks more slowly than the scale`;
export const fourNumbersBlendedAcross = "Four numbers, blended across the shape";
export const variesByCorner = "Varies by corner";

export const rotationInPieces = "Rotation in the pieces";
export const continuity = "Continuity";

export const holdToSeePlain = "Hold to see the plain deformation, to which only the full shape responds";
export const holdForPlain = "Hold for plain";

export const subject = "Subject";
export const shape = "Shape";
export const gridAround = (subject: string) => `The grid is around the ${subject} again.`;
export const fitGrid = (subject: string) => `Fit the grid to the ${subject}`;
export const splitInto = "Split into";
export const closedCurve = "closed curve";
export const curveOf = (count: number) => `closed curve, ${count} knots`;
export const fromTo = (a: string, b: string) => `${a} to ${b}`;
export const morphAt = (percent: string) => `the morph at ${percent}%`;
export const betweenShapes = (a: string, b: string) => `Between ${a} and ${b}`;
export const morphFrom = (a: string, b: string) => `Morph from ${a} to ${b}`;
export const morphThenShowsThis = "The morph then shows this deformation too";
export const deformInMorphToo = "Deform it in the morph, too";
export const chooseShapeToDeform = "Choose a shape to deform";
export const gridPlacedAroundAlso = "The grid is placed around it. It also becomes shape A of the morph.";
export const withGrid = (name: string) => `${name}, with the grid around it.`;

export const dragPointGrid = "Drag a point of the grid.";
export const everyPartAtEvery = "Every part, at every scale, follows.";
export const showMe = "Show me";
export const startOver = "Start over";
export const gridAtRest = "The grid is at rest.";

export const thisShapeNotDeformed = "This shape is not deformed";
export const hasSeveralStatesDeformation =
  "It has several states. The deformation reverses a part of each address (Fujimoto, equations 5 and 6), and in a graph the reversed address may lead nowhere. You can deform its picture like a photo instead: it is cut into parts, and those into parts.";
export const deformPicture = "Deform its picture";
export const backToMorph = "Back to Morph";
export const backToSystemsMaps = "Back to the systems of maps.";
export const deformSystemMapsInstead = "Deform the system of maps instead";

export const swaysAndEveryPart = "It sways, and every part sways about its own stem.";
export const oneSideLiftedIn =
  "One side is lifted in the middle, and every part is lifted with it, at every scale.";

export const sway = "Sway";
export const upperRowsSwingBack = "The upper rows swing back and forth, as in wind; the lowest stays";
export const breathe = "Breathe";
export const allPointsMoveOut = "All points move out from the centre and back";
export const wave = "Wave";
export const waveRunsAlongGrid = "A wave runs along the grid";
export const pullCorner = "Pull a corner";
export const upperRightCornerPulled = "The upper right corner is pulled out and released";
export const still = "Still";
export const oneGridForAll = "One grid for all times: the current one";

export const notDrawn = (problem: string) => `Its picture could not be drawn: ${problem}`;

export const singleKeyframeDoesNot = "a single keyframe does not move. Choose a motion, or add another";

export const keyframes = "Keyframes";
export const keyOf = (number: number, count: number) => `Keyframe ${number} of ${count}`;
export const keyAt = (number: number, percent: string) => `Keyframe ${number}, at ${percent}`;
export const oneGridForAllTimes = "One grid for all times. Choose a motion, or add keyframes.";

export const timeInPercent = "Time in percent";
export const durationInSeconds = "Duration in seconds";
export const loop = "Loop";
export const keysFull = (count: number) => `There are ${count} keyframes already`;
export const keepGridThisMoment = "Keep the grid of this moment";
export const addKeyframe2 = "Add keyframe";
export const key = (number: number, count: number) => `Key ${number} of ${count}`;
export const deleteKey = (number: number) => `Delete keyframe ${number}`;
export const keyIsAt = (percent: string, number: number, count: number) =>
  `Keyframe at ${percent}, ${number} of ${count}.`;
export const keyDeleted = (number: number, left: number) => `Keyframe ${number} deleted. ${left} left.`;

export const nothingMoves = (percent: string) => `${percent}, nothing moves`;
export const betweenKeyframes = "between keyframes";
export const keyCount = (number: number, count: number) => `keyframe ${number} of ${count}`;

export const n0OnlyLargestScale = "0, only the largest scale responds";
export const plainOf = (kb: string, ke: string) => `${kb} of ${ke}, plain`;
export const scatteredOverFullShape = ", scattered over the full shape";
export const localityOf = (kb: string, ke: string, scattered: string) => `${kb} of ${ke}${scattered}`;
export const n0OnlyFullShape = "0, only the full shape";
export const scalesOf = (count: string) => `${count} scales`;
export const keepsDirection = "Keeps its direction";
export const upStaysUpIn = "Up stays up in every part.";
export const rotatesWithPiece = "Rotates with the piece";
export const alsoMirroredWherePiece = "It is also mirrored where the piece is.";
export const rotatesNeverMirrored = "Rotates, never mirrored";
export const onlyRotationPieceCounts = "Only the rotation of the piece counts.";
export const rotatesAndFlattensLike = "Rotates and flattens like the piece";
export const wholeMapExceptSize = "The whole map except its size: best for ferns.";
export const automatic = "Automatic";
export const chosenToSuitShape = "Chosen to suit the shape.";
export const sharedCorners = "Shared corners";
export const neighboursAgreeWhereTheir =
  "Neighbours agree where their corners meet: gaskets, squares, curves.";
export const smoothingScaleByScale = "Smoothing, scale by scale";
export const forPiecesTilePlane = "For pieces that tile the plane without corners, such as dragons.";
export const none = "None";
export const partsMayComeApart =
  "Parts may come apart, more so with more roughness: for ferns and trees, whose leaves sway freely.";
export const averagesAsPublished = "Averages, as published";
export const meanAllTermsOver =
  "The mean of all terms over each of the smallest parts, joined by triangles. Fine tips lean towards their neighbours.";
export const averagesSmoothTermsExact = "Averages, smooth terms exact";
export const frondsVariantTermsShuffle =
  "Frond’s variant: the terms that shuffle nothing stay exact, and only the others are averaged.";
export const sharedCorners2 = "shared corners";
export const averagesWithSmoothTerms = "averages with the smooth terms exact";
export const averagesAsPublished2 = "averages as published";
export const automaticIs = (got: string | number) => `automatic: ${got}`;
export const notAvailable = (got: string, asked: string) => `${got} (not available here: ${asked})`;

export const chooseAnother = (now: string) => `${now}. Choose another shape`;
export const noneUsed = "none";
export const mirrorMoves = "Mirror what is moved";
export const partsEachWay = "Parts per side";
