/** What the tool Fit says. */

export const copiesFromPoint = "copies from point";
export const copiedEnd = (piece: number, last: boolean) =>
  `Piece ${piece} copies ${last ? "up to" : "from"} point`;

export const pieceOf = (count: number) => `Piece of ${count}`;
export const pieceNumber = (number: number) => `Piece ${number}`;

export const zoomOut = "Zoom out";
export const zoomIn = "Zoom in";
export const resetView = "Reset the view";

export const shapeAndPicture = "Shape and picture";
export const cuttingOut = "Cutting out";
export const holdHideFit = "Hold: hide the fit";
export const hideOrShowOutline = "Hide or show the outline";
export const hideOrShowKnots = "Hide or show the knots";
export const hideOrShowPicture = "Hide or show the picture";
export const nextOrPreviousDrag = "Next or previous drag mode: move, leaf, not leaf";
export const smallerOrLargerBrush = "Smaller or larger brush";
export const moveBrushWithPicture = "Move the brush, with the picture focused (Shift: finer)";
export const paintThereHoldTo = "Paint there; hold to paint while moving";
export const cancelStrokeDeselectBrush = "Cancel the stroke, deselect the brush";
export const undoLatestStrokeFirst = "Undo: the latest stroke first";

export const copies = "Its copies";
export const edgesCopySameArc =
  "Edges that copy the same arc have the same colour. Point at an edge to see its arc, dashed.";
export const showEdgeCopiesArc = "Show which edge copies which arc";
export const copyOf = (count: number) => `Copy, of ${count}`;
export const stepsGrowth = "Steps of growth";
export const allOfIt = "all of it";
export const showAll = "Show all";

export const timesAsLong = (ratio: string) => `${ratio} times as long`;
export const timesAsHigh = (ratio: string) => `${ratio} times as high`;
export const rotatedByHalfTurn = "rotated by half a turn";
export const edgeCopies = (span: number, changes: string) =>
  `This edge copies that arc of ${span} edges: ${changes}.`;
export const polygonKnots = "the polygon of knots";

export const fit = "Fit";
export const frondFindFormulaOutline = "Frond: find the formula of an outline";
export const outlineAndFit = "Outline and fit";
export const outline = "Outline";
export const fitCouldNotLoaded = "The fit could not be loaded";

export const pointM0To =
  "Point m (0 to M) of a piece is e + b m / M + c times point start + 2 m of the ring of feature points, or start + 2 (M - m) where it is reversed.";
export const percentDiagonalOutlinesBounding = "percent of the diagonal of the outline's bounding box";

export const mirrored = "Mirrored";
export const point = "Point";
export const point2 = "Which point";
export const remove = "Remove";
export const contractivity = "Contractivity";
export const example = "An example";
export const readingOf = (name: string) => `Reading ${name} …`;

export const yourFits = "Your fits";
export const saved = "Saved";
export const saveThisFit = "Save this fit";
export const showFewer = "Show fewer";
export const showAllOf = (count: number) => `Show all ${count}`;
export const yourFitsOf = (count: number) => `Your fits (${count})`;
export const thisVersionFrondCannot = "This version of Frond cannot read it";
export const moreFor = (name: string) => `More for ${name}`;
export const useAs = "Use as A";
export const useAsB = "Use as B";
export const deform = "Deform it";
export const deformPhoto = "Deform its photo";
export const rename = "Rename";
export const unpin = "Unpin";
export const pin = "Pin";

export const isKept = (name: string) => `${name} is saved under “Your fits”.`;
export const isOnStage = (name: string) => `${name} is on the stage.`;
export const wasRemoved = (name: string) => `${name} was removed.`;
export const undo = "Undo";
export const isBack = (name: string) => `${name} is back.`;

export const numbers = (count: number) => `${count} numbers`;
export const bytes = (count: string) => `${count} bytes`;
export const error = (percent: string) => `${percent} error`;

export const notLoaded = (what: string, problem: string) => `${what} could not be loaded: ${problem}`;
export const graphs = "Graphs";
export const curvesPlane = "Curves of the plane";
export const fit2 = "Fit of";
export const outline3 = "An outline";
export const leafCoastClosedCurve = "A leaf, a coast: a closed curve";
export const graph = "A graph";
export const profileTimeSeriesFunction = "A profile, a time series: a function";
export const curve = "A curve";
export const fractalCurveThroughPoints = "A fractal curve through points of the plane";

export const backTo = (name: string) => `Back to ${name}`;
export const leaf = "Leaf";
export const fitting = "Fitting …";
export const maps = "Maps";
export const featurePoints = "Feature points";
export const mapleLeaf = "Maple leaf";
export const use = "Use";
export const becomesLastShapeMorph = "Becomes the last shape of the morph, not the first";
export const circleOf = (number: number, factor: string) =>
  `What piece ${number} makes of a circle: ${factor} times as long at most. It must stay inside.`;
export const takesTo = (number: number, name: string, x: string, y: string) =>
  `Piece ${number} takes ${name} to ${x}, ${y}. Arrow keys move it, Shift for finer steps`;

export const inCopyXAnd = "In a copy, x and y depend";
export const howXAndY = "How x and y of a copy depend on each other";
export const onThemselvesOnly = "on themselves only";
export const eq8XAnd = "Eq 8: x and y are two functions of one t";
export const onBoth = "on both";
export const eq9CopiesRotate = "Eq 9: copies rotate and lean";
export const times = (factor: string) => `${factor} times`;
export const atMostLarge = (size: string) => `at most ${size} times as large`;
export const mirroredLarge = (size: string) => `${size} times as large, mirrored`;
export const large = (size: string) => `${size} times as large`;
export const rotatedLarge = (size: string, degrees: number) =>
  `${size} times as large, rotated by ${degrees}°`;
export const entryOf = (name: string, number: number) => `${name}, piece ${number}`;
export const copySimilarToWhat =
  "The copy is similar to what it copies, rotated along the straight side from point to point";
export const alongSide = "Along its side";
export const sameMirroredAtSide = "The same, mirrored at its side";
export const copyStartsWhereLast = "The copy starts where the last point goes.";
export const runsBackwards = "Runs backwards";
export const addsPointInMiddleThis = "Adds a point in the middle of this piece, on the curve";

export const curve2 = "The curve";
export const examples = "Examples …";
export const curvePassesThroughPoints =
  "The curve passes through its points, wherever they lie. Every piece from point to point is a copy of it. The factor of a copy is a matrix of two rows that must shorten every direction.";
export const xOf = (number: number) => `x of point ${number}`;
export const yOf = (number: number) => `y of point ${number}`;
export const whenReached = (number: number) => `Time of point ${number}`;
export const n10NumbersMapT =
  "10 numbers a map, of which t takes two; 8 where x and y depend only on themselves";
export const howMuchEachStepShrinks =
  "How much each step shrinks the rest, in the metric of eq 2 with norms for factors";

export const dragPointsAnywhereTwo =
  "Drag the points anywhere. The two arrows of a piece rotate and lean its copy, inside the circle.";
export const functionOfT = (name: string) => `${name} as a function of t`;
export const overT = (name: string) => `${name} over t`;

export const attractorOf = (count: number) =>
  `It is the attractor of ${count} maps of the plane, and those are used exactly.`;
export const mapsNeedTBesides =
  "Its maps need t besides x and y, so an outline of short straight sides is used, closed from its last point to its first.";

export const numbersThisCurveDamaged =
  "The numbers of this curve are damaged. Frond shows Koch’s curve instead.";

export const kochsCurve = "Koch’s curve";
export const fourCopiesEachThird =
  "Four copies, each a third as long, rotated along their sides (von Koch 1904).";
export const arrowhead = "Arrowhead";
export const threeCopiesEachHalf =
  "Three copies, each half as long, two of them mirrored: the gasket as one curve, the side view of Figure 3.";
export const dragon = "Dragon";
export const twoCopiesEach1 =
  "Two copies, each 1/√2 as long, rotated by 45 degrees to either side; the second runs backwards (Heighway’s dragon).";
export const togetherSection24 = "Together (section 2.4)";
export const copiesLeanXDepends =
  "Copies that lean: x depends on y and y on x, and neither is a function by itself (eq 9).";
export const apartEq8 = "Apart (eq 8)";
export const xAndYTwo = "x and y are two rough functions of one t, independent of each other.";

export const curveArrowKeysMove = "The curve. Arrow keys move it, plus and minus zoom, 0 resets the view.";
export const lastStays = (problem: string) => `${problem} Frond still shows the last curve.`;
export const drawnWith = (count: string) => `Drawn with ${count} points, the most possible`;

export const pointsCurve = "Points of the curve";
export const curvePointAt = (number: number, x: string, y: string) =>
  `Point ${number} at x = ${x}, y = ${y}: arrow keys move it, Shift for finer steps`;
export const curvePointNow = (number: number, x: string, y: string) => `Point ${number}: ${x}, ${y}`;

export const curvePlane = "Curve of the plane";
export const thereNoOtherShape = "there is no other shape";
export const curveNotUsed = (problem: string) => `This curve cannot be used there: ${problem}`;

export const noCanvas = "no canvas";
export const fitNotSaved = (problem: string) => `The fit could not be saved: ${problem}`;

export const graphsNotLoaded = (problem: string) => `Graphs could not be loaded: ${problem}`;

export const outlineAndFitArrow =
  "The outline and its fit. Arrow keys move them, plus and minus zoom, 0 resets the view. With a brush selected, arrow keys move the brush and the space bar paints.";
export const fitToStage = "Fit to the stage";

export const paintingLeaf = "Painting: leaf.";
export const paintingNotLeaf = "Painting: not leaf.";

export const holdToSeeOutline = "Hold to see the outline or the picture without the fit";
export const holdToCompare = "Hold to compare";

export const sizeFit = "Size of the fit";
export const bytesInFit = "Bytes in the fit";
export const bytesOf = (count: number) => `${count} bytes`;
export const numbersInFit = "Numbers in the fit";
export const numbersIs = (count: number) => `${count} numbers`;
export const mapsInFit = "Maps in the fit";
export const mapsAndNumbers = (maps: number, numbers: number) => `${maps} maps, ${numbers} numbers`;

export const shown = "Shown";
export const picture2 = "Picture";
export const knots = "Knots";
export const controlPoints = "Control points";

export const thereNoneAnyMore = "there is none any more";
export const curveCannotDrawn = "its curve cannot be drawn";
export const photoNotDeformed = (problem: string) => `This photo cannot be deformed: ${problem}`;
export const fitNotUsed = (problem: string) => `This fit cannot be used there: ${problem}`;

export const findingLeaf = "Finding the leaf …";
export const nothingStandsOutYet = "Nothing stands out yet";
export const onePart = "one part";
export const partCount = (count: number) => `${count} parts`;
export const partsSearching = (parts: string) => `${parts}, searching …`;
export const cutOutOf = (parts: string) => `Cut out: ${parts}`;
export const waitingForOutline = "Waiting for an outline";
export const noFit = "No fit";
export const errorAndNumbers = (error: string, count: number) => `${error} error, ${count} numbers`;
export const errorSoFar = (error: string) => `, ${error} error so far`;
export const fittingPercent = (percent: number, error: string) => `Fitting, ${percent}% done${error}`;
export const stoppedBeforeFirstFit = "Stopped before the first fit";
export const numbersOf = (count: number) => `${count} numbers`;
export const polylineBestCorners = "Polyline, best corners";
export const polylineWhoseCornersWere = "A polyline whose corners were adjusted by least squares";
export const polylineSplit = "Polyline, split";
export const polylineThroughFeaturePoints = "A polyline through feature points";
export const bezierCurves = "Bézier curves";
export const smoothPiecesAsFrom = "Smooth pieces, as from a tracing program";
export const fourierDescriptors = "Fourier descriptors";
export const lowestFrequenciesOutline = "The lowest frequencies of the outline";
export const asInPaper = "As in the paper";
export const collageLeastSquaresBy = "Collage least squares by Cochran, Hart and Flynn";
export const cornersAdjustedByLeast = "Corners adjusted by least squares, packed in the same way";
export const cubicPiecesCountedAs = "Cubic pieces, counted as an ideal coder would write them";
export const lowestFrequenciesCountedAs = "The lowest frequencies, counted as an ideal coder would";
export const percentOfPerimeter = (percent: number) => `${percent}% of its perimeter`;
export const asRoughAsOutline = "As rough as the outline.";
export const smoother = (perimeter: string) => `Smoother than the outline: it has ${perimeter}.`;
export const rougher = (perimeter: string) => `Rougher than the outline: it has ${perimeter}.`;
export const sameRoughness = (perimeter: string) => `About as rough as the outline: it has ${perimeter}.`;

export const fitted = (error: string) => `Fitted: ${error} percent error.`;
export const fittedWith = (maps: number, error: string) =>
  `Fitted with ${maps} maps: ${error} percent error.`;
export const stoppedBestFitSo = "Stopped. The best fit so far stays.";

export const removedLastStroke = "Removed the last stroke.";

export const outlineNotFitted = (problem: string) => `This outline cannot be fitted: ${problem}`;

export const backOnStage = (name: string) => `${name} is on the stage again.`;
export const stageUnchanged = (problem: string) => `${problem} The stage is unchanged.`;

export const rotatedQuarterTurnTo = "rotated a quarter turn to the right";
export const turnedUpsideDown = "turned upside down";
export const rotatedQuarterTurnToLeft = "rotated a quarter turn to the left";
export const photoIs = (rotation: string) => `The photo is ${rotation}.`;
export const notRotated = (problem: string) => `The photo cannot be rotated: ${problem}`;

export const fittedWithin = (bytes: number, error: string) =>
  `Fitted within ${bytes} bytes: ${error} percent error.`;

export const rotatedTo = (degrees: number, side: string) => `rotated ${degrees}° ${side}`;
export const toTheLeft = "to the left";
export const toTheRight = "to the right";
export const mirroredToo = "mirrored";
export const keptFits = (most: number, pixels: number) =>
  `This browser keeps the last ${most} fits and those you pin, with their outlines and, for a photo, a small picture of the leaf (${pixels} pixels). Links do not contain them.`;
export const keptFitsBenefit = (about: string) =>
  `You can reopen a saved fit without fitting again. ${about}`;
export const pinnedAside = " · pinned";
export const errorAndAmount = (error: string, amount: string) => `${error} error, ${amount}`;
export const stoppedAt = (error: string, amount: string) => `Stopped: ${error} error, ${amount}`;
