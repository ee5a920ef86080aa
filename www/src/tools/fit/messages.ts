/** What the tool Fit says. */
import { counted } from "#format/plural";

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

export const copiesFrom = "copies from";

export const countingVotesForEvery = "Counting votes for every possible smaller copy.";
export const findMapsTheirVotes = "Find the maps: their votes will appear here.";
export const dragPointsGraphChange =
  "Drag the points of the graph, change the roughness of its pieces, or find the maps of a series.";
export const hitsUpTo = (count: number) => `Hits of the ${count} largest clusters: up to`;
export const clusterHits = (name: string, hits: string) => `${name}: ${hits} hits`;
export const map = "Map";
export const echo = "Echo";
export const clutter = "Clutter";

export const functionLabel = "The function";
export const figure1 = "Figure 1";
export const everyPieceSmallerCopy = "Every piece is a smaller copy of";
export const whatEveryPieceCopies = "What every piece copies";
export const sameGraphAsCurve =
  "The same graph as a curve through points of the plane. Its points may go anywhere, and its copies may rotate and lean";
export const asCurvePlane = "As a curve of the plane";
export const roughnessOf = (number: number) => `Roughness of piece ${number}`;
export const copyRunsFromRight = "The copy runs from right to left.";
export const mirrored = "Mirrored";
export const addsPointInMiddle = "Adds a point in the middle of this piece, on the graph";
export const point = "Point";
export const veryRough = "very rough";
export const point2 = "Which point";
export const placeOf = (number: number) => `Position of point ${number}`;
export const heightOf = (number: number) => `Height of point ${number}`;
export const remove = "Remove";
export const boxDimension = "Box dimension";
export const byCountingBoxes = "by counting boxes";
export const fromEquationFactors = "from the equation of the factors";
export const contractivity = "Contractivity";
export const howMuchEachStep = "how much each step shrinks the rest, in the metric of eq 2";
export const integral = "Integral";
export const exactOnlyWhereParts = "exact only where parts start and end at points";
export const widestGap = "Widest gap";
export const betweenNeighbouringPieces = "between neighbouring pieces";

export const candidatesMostHitsFirst = "Candidates, most hits first";
export const fewer = "Fewer";
export const allOf = (count: number) => `All ${count}`;
export const pick = (name: string) => `Select ${name}`;
export const partMustStartBefore = "The part must start before it ends.";

export const theirScalesAndC = "their scales a and c";
export const theirMainDirections = "their main directions";

export const findMapsSeries = "Find the maps of a series";
export const points = (count: string) => `${count} points`;
export const dropTableNumbersHere =
  "Drop a table of numbers here: a time series or the heights of a mountain. Frond finds the smaller copies it is made of.";
export const tableNumbers = "A table of numbers";
export const openTable = "Open a table …";
export const reading = "Reading …";
export const example = "An example";
export const orExample = "Or an example …";
export const featurePointsCoarseAnd = "Feature points, coarse and fine";
export const smoothingAgainstNoise = "Smoothing against noise";
export const percentOfLength = (percent: string) => `${percent} percent of the length`;
export const alsoFindsCopiesRun = "Also finds copies that run backwards. Takes twice as long.";
export const includeMirroredCopies = "Include mirrored copies";
export const findMaps = "Find the maps";
export const search = "Search";
export const phaseVotes = (phase: string, votes: string) => `${phase}: ${votes} votes`;
export const stop = "Stop";

export const clustersVotes = "Clusters of votes";
export const votesTook = (votes: string, seconds: string) => `${votes} votes, ${seconds} s`;
export const plot = "Plot";
export const scalesAndC = "Scales a and c";
export const howMuchCopiesShrink = "How much copies shrink horizontally and vertically";
export const mainDirections = "Main directions";
export const twoFiveDirectionsIn = "The two of five directions in which clusters spread most";
export const noMapGotMore = "No map got more than a few votes. Try other feature points or other smoothing.";
export const plotAxes = (across: string, up: string) => `Across: ${across}; up: ${up}.`;
export const featurePointsCopiedPart = "The feature points of the copied part, and where the map takes them";
export const showSelectedMapOn = "Show the selected map on the graph";
export const maximumError = "Maximum error";
export const n01Height = "0.1% of the height";
export const percentOfHeight = (percent: string) => `${percent} percent of the height`;
export const assemble = "Assemble";
export const assembleSelection = "Assemble selection";
export const offMapsKeepTheir = "Off: maps keep their values, as in the paper, and pieces may leave gaps.";
export const closeGapsBetweenPieces = "Close gaps between pieces";
export const mapsAuthorsSelectedBy =
  "The maps that the authors selected by hand and refined, with their domains";
export const pickTable3 = (found: number) => `Select those of Table 3 (${found} of 7 found)`;
export const assembledOf = (kind: string, count: number, error: string, cost: string) =>
  `${kind} of ${count} pieces: ${error}. ${cost}`;

export const clustersFound = (count: number, maps: number) =>
  `Found ${count} clusters; ${maps} of them are maps of their own.`;
export const stopped = "Stopped.";
export const assembledFrom = (count: number, error: string) => `Assembled from ${count} pieces, ${error}.`;

export const everyPieceCopiesWhole = "Every piece copies the whole.";
export const everyPieceCopiesStretch = "Every piece copies the stretch between two points.";
export const everyPieceCopiesAny = "Every piece copies any part.";
export const sameInPieces = (count: number) => `The same function in ${count} pieces.`;
export const thesePiecesCannotCut =
  "These pieces cannot be cut so that all parts start and end at points. Their parts were moved to the nearest points.";
export const planeCurveOf = (count: number) => `A curve of the plane in ${count} pieces.`;
export const thesePiecesCannotCutSo =
  "These pieces cannot be cut so that all parts start and end at points. First choose “A stretch”.";

export const twoMapsTable1 = "Two maps (Table 1)";
export const testInPaperFunction =
  "The test in the paper: a function of two maps, to be recovered from 129 points.";
export const hiddenVariableFig4 = "Hidden variable (Fig 4)";
export const projectionCurveInSpace =
  "A projection of a curve in space. It was long thought not to be self-similar.";
export const measuredWithNoise = "Measured, with noise";
export const threeMapsUnderNoise =
  "Three maps under noise of 1.7 percent of the height. Smoothing recovers them.";

export const picture = "a picture";
export const outline2 = "an outline";
export const notSeries = (name: string, what: string) =>
  `${name} contains ${what}, not a series. Choose “Outline” for it, or open a table with two columns of numbers.`;

export const n65And129 = "65 and 129";
export const halvesHalves2K = "Halves of halves: 2^k + 1";
export const n55And163 = "55 and 163";
export const thirdsThirds23 = "Thirds of thirds: 2·3^k + 1";
export const n33And65 = "33 and 65";
export const fewDoneInInstant = "Few: done in an instant";
export const seriesOnStage = (name: string, count: number) => `${name}: ${count} points are on the stage.`;

export const whole = "The whole";
export const fifEveryPieceSmaller = "FIF: every piece is a smaller copy of the whole graph.";
export const stretch = "A stretch";
export const rfifEveryPieceSmaller =
  "RFIF: every piece is a smaller copy of the stretch between two of the points.";
export const anyPart = "Any part";
export const pfifEveryPieceSmaller = "PFIF: every piece is a smaller copy of any longer part.";
export const clutterOf = (number: number) => `Clutter ${number}`;
export const mapOf = (number: number) => `Map ${number}`;
export const echoOf = (clusters: string) => `Echo ${clusters}`;
export const soSmallAlmostEverything = "So small that almost everything is a copy of it.";
export const mapOwn = "A map of its own.";
export const undoMap = (number: number) => `undo map ${number}`;
export const applyMap = (number: number) => `apply map ${number}`;
export const followsFrom = (steps: string) => `It follows from stronger ones: ${steps}.`;
export const fitsNowhere = "fits nowhere";
export const errorOn = (error: string, count: number) => `${error}% error on ${count}`;
export const errorAtMost = (worst: string, rms: string) => `error ${worst} at most, ${rms} RMS`;
export const copiesDoNotPay = (numbers: number) =>
  `A polyline with ${numbers} numbers: copies save nothing at this tolerance.`;
export const costIs = (numbers: number, polyline: number) =>
  `It takes ${numbers} numbers; a polyline of the same accuracy takes ${polyline}.`;
export const spreadIn = (two: string, three: string) =>
  `${two} of the spread lies in these two directions, ${three} in three.`;
export const countingBC = "Counting a, b, c";
export const countingDE = "Counting d, e";
export const naming = "Naming";

export const graphLeftAndRight =
  "The graph. Left and right arrows move it, plus and minus zoom, 0 resets the view.";
export const off = "Off";
export const readingOf = (name: string) => `Reading ${name} …`;

export const pointsGraph = "Points of the graph";
export const knotAt = (number: number, t: string, x: string) =>
  `Point ${number} at t = ${t}, x = ${x}: arrow keys move it, Shift for finer steps`;
export const pointAt = (number: number, place: string) => `Point ${number}: ${place}`;

export const largestErrorHere = "largest error here";

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

export const cutOut = "Cut out";
export const step = "Step";
export const n1CutOut = "1 Cut it out";
export const markLeafInPicture = "Mark the leaf in the picture";
export const n2Fit = "2 Fit it";
export const findFormulaOutline = "Find the formula of its outline";
export const waitForNewOutline = "Wait for the new outline";
export const findFormulaThisOutline = "Find the formula of this outline";
export const findingOutline = "Finding the outline …";
export const fitThisOutline = "Fit this outline";
export const threshold = "Threshold";
export const automaticThreshold = "Automatic threshold";
export const removesThinPartsStick = "Removes thin parts that stick out, where they begin";
export const removeStalk = "Remove the stalk";
export const automatic = "automatic";
export const thresholdBy = (amount: string, direction: string) => `${amount} ${direction} than automatic`;
export const nothingWasFoundDraw = "Nothing was found. Draw a stroke over the leaf with Leaf.";
export const backTo = (name: string) => `Back to ${name}`;
export const partClose = (number: number, percent: string) =>
  `Part ${number} lies close by and is left out. It is ${percent} as large.`;
export const fillsGapBetweenTwo = "Fills the gap between the two as a stroke would. You can undo it";
export const partJoined = (number: number) => `Part ${number} is joined to it.`;
export const joinPart = (number: number) => `Join part ${number} to it`;
export const left = "Left";
export const rotatePhotoQuarterTurn = "Rotate the photo a quarter turn to the left";
export const right = "Right";
export const rotatePhotoQuarterTurnTo = "Rotate the photo a quarter turn to the right";
export const upsideDown = "Upside down";
export const rotatePhotoByHalf = "Rotate the photo by half a turn";
export const rotate = "Rotate it";
export const move = "Move";
export const dragToMovePicture = "Drag to move the picture";
export const leaf = "Leaf";
export const paintOverLeaf = "Paint over the leaf";
export const notLeaf = "Not leaf";
export const paintOverWhatNot = "Paint over what is not the leaf";
export const brush = "Brush";
export const tooLittleOrToo =
  "Too little or too much? Choose Leaf or Not leaf and paint. Touching leaves are cut out as one: paint out the ones you do not mean with Not leaf.";
export const brushSize = "Brush size";
export const brushPercent = (percent: number) => `${percent}% of the picture`;
export const onStrokeChangesOnly =
  "On: a stroke changes only what it covers. Off: it also includes similar pixels nearby";
export const doNotSpread = "Do not spread";
export const onlyPaintedPixelsChange = "Only painted pixels change.";
export const oneStrokeOftenEnough =
  "One stroke is often enough: similar pixels nearby are included. Longer strokes spread farther.";
export const undoStroke = "Undo stroke";
export const redoStroke = "Redo stroke";
export const part = "Which part";
export const partNumber = (number: number) => `Part ${number}`;
export const partPercent = (percent: number) => `, ${percent}% of the picture`;

export const accuracy = "Accuracy";
export const fitAgain = "Fit again";
export const fitting = "Fitting …";
export const cancel = "Cancel";
export const firstFitWillAppear = "The first fit will appear in a moment.";
export const thisFitHasNo =
  "This fit has no outline to compare with. Choose the photo again to see the accuracy, or ask for another number: Frond then fits the curve itself again.";
export const measuring = "Measuring …";
export const fittingOtherMethodsWith = "Fitting other methods with the same amount of data …";
export const otherMethodsWithSame = "Other methods with the same amount of data";
export const closedCurveFrond = "Closed curve (Frond)";
export const thisFit = "This fit";
export const fittingMore = "Fitting more …";

export const model = "Model";
export const method = "Method";
export const knotsAndEdgesStraight =
  "Knots and edges that are straight or copies of arcs: closed by construction";
export const limitedBytes = "Limited bytes";
export const cornersAndParabolasAs = "Corners and parabolas, as accurate as so many bytes allow";
export const asInPaperCollage = "As in the paper (collage)";
export const cochranHartAndFlynn = "Cochran, Hart and Flynn, section 3.2";
export const everyEdgeStraightOr =
  "Every edge is straight or a smaller copy of another part of the outline. It has no gaps, however rough it is.";
export const maps = "Maps";
export const featurePoints = "Feature points";
export const mapsFrom261 = (count: number) => `${count} maps from 261 feature points, as in Fig 7`;
export const mapsOf = (count: number) => `${count} maps`;
export const xAndY = "x and y";
export const matrixFourNumbersEach = "A matrix of four numbers each (eq 9)";
export const separableNumberForEach = "Separable: a number for each coordinate (eq 8)";
export const copiesStart = "Copies start";
export const wherePiecesDo = "where pieces do";
export const recurrentRfif = "Recurrent: an RFIF";
export const partitionedPfif = "Partitioned: a PFIF";
export const endsInPaperFree = "The ends in the paper are free, and leave gaps";
export const tieEndsPieces = "Tie the ends of the pieces";
export const piecesDoNotMeet = (widest: string, mean: string) =>
  `Pieces do not meet: the widest gap is ${widest} of the size, the mean ${mean}. The picture marks them.`;
export const allPiecesMeetThere = "All pieces meet: there are no gaps.";

export const outline4 = "The outline";
export const smoothing = "Smoothing";
export const forNoise = "for noise";
export const thisOutlineVeryTangled =
  "This outline is very tangled. You can fit it, but smoothing will improve it.";
export const outline5 = "Which outline";
export const overSize = (percent: string) => `over ${percent}% of the size`;

export const source = "Source";
export const photoOrOutlineFile = "Photo or outline file";
export const choosePhotoOrOutline = "Choose a photo or outline";
export const orDrop = (formats: string) =>
  `Or drop a file anywhere, or paste it: ${formats}. Your file stays on this device; links contain only the fitted curve.`;
export const mapleLeaf = "Maple leaf";
export const fiveLobesWithPointed = "Five lobes with pointed teeth and round bays";
export const oakLeaf = "Oak leaf";
export const roundLobesAndNarrow = "Round lobes and narrow bays";
export const island = "Island";
export const coastRoughAtEvery = "A coast that is rough at every magnification";
export const noisyLeaf = "Noisy leaf";
export const badlyMeasuredMapleLeaf = "A badly measured maple leaf: try the smoothing";
export const orOneGrownHere = "Or one grown here";
export const growAnother = (about: string) => `${about}. Click again to grow another`;
export const pixels = (width: string, height: string) => `${width} × ${height} pixels`;
export const sizeAndOutline = (size: string, points: string) => `${size}, outline of ${points}`;
export const keptWithOutline = (points: string) => `One of your fits, with its outline of ${points}`;
export const fitWithoutSource = "A fit without its source";
export const severalOutlines = (count: number, points: string) => `${count} outlines; this one has ${points}`;
export const grownBy = (points: string) => `Generated, ${points}`;
export const generated = "Generated";

export const use = "Use";
export const becomesLastShapeMorph = "Becomes the last shape of the morph, not the first";
export const fernBecomesThisOutline =
  "A fern becomes this outline, edge by edge, in one piece along the whole path";
export const fromFern = "From a fern";
export const leafCutOutAlong = "The leaf, cut out along the curve, under the grid";
export const hasStalk = (percent: number) =>
  `It has a stalk, ${percent}% as long as the leaf. In a morph with a leaf without stalk, few knots may find a partner, and the curve may cross itself.`;
export const morphsAndDeformationsUse =
  "Morphs and deformations use corners only. They replace its parabolas by straight sides too short to see.";
export const morphsAndDeformationsUseClosed = "Morphs and deformations use the closed curve: it has no gaps.";
export const saveAs = "Save as";
export const saveAsOf = (format: string) => `Save as ${format}`;
export const stillImprovingOrB = "Still improving; A or B will get the final fit.";
export const goesThereWhenDone =
  "It goes there when it is done. Press again to stay. Cancel uses the best so far.";

export const bytes2 = "Bytes";
export const anyNumberBytes = "Any number of bytes";
export const curveCornersAndParabolas =
  "A curve of corners and parabolas, as accurate as so many bytes allow. The bytes hold the whole curve: in a link they take a third more characters, and a morph or a deformation comes on top. It has no copies of its parts.";
export const thisFitHasNoOutline =
  "This fit has no outline to compare with. Choose the photo again to see the accuracy, or ask for other bytes: Frond then fits the curve itself again.";
export const fittingOtherMethodsWithSame = "Fitting other methods with the same number of bytes …";
export const othersWithBytes = (bytes: string) => `Other methods with ${bytes} bytes`;
export const cornersAndParabolasFrond = "Corners and parabolas (Frond)";
export const polylinesPackedInSame =
  "Polylines are packed in the same form. Bézier curves and Fourier descriptors are counted as an ideal coder would write them, so in practice they may take a few bytes more.";

export const turnOffDoNot =
  "Turn off “Do not spread” first. With it, a stroke brings back only what it covers.";

export const rootMeanSquareDistance =
  "Root mean square distance from the outline to the fit, in percent of the diagonal of its bounding box";
export const errorRms = "Error (RMS)";
export const noPointOutlineOr = "No point of the outline or of the fit is farther from the other";
export const largestDistanceHausdorff = "Largest distance (Hausdorff)";
export const perimeterFitDividedBy = "The perimeter of the fit divided by that of the outline";
export const perimeter = "Perimeter";
export const boxDimensionBetween1 =
  "Box dimension between 1/64 and 1/256 of the diagonal: original, fit, and the difference dD";
export const dimension = "Dimension";
export const rms = "RMS";
export const differenceInBoxDimension = "Difference in box dimension";

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

export const crossesItself = (times: number) =>
  `This outline crosses itself ${times === 1 ? "once" : times >= 99 ? "99 times or more" : `${times} times`}. You can fit it as it is. Smoothing removes crossings that come from noise.`;
export const rotatedTo = (degrees: number, side: string) => `rotated ${degrees}° ${side}`;
export const toTheLeft = "to the left";
export const toTheRight = "to the right";
export const mirroredToo = "mirrored";
export const keptFits = (most: number, pixels: number) =>
  `This browser keeps the last ${most} fits and those you pin, with their outlines and, for a photo, a small picture of the leaf (${pixels} pixels). Links do not contain them.`;
export const keptFitsBenefit = (about: string) =>
  `You can reopen a saved fit without fitting again. ${about}`;
export const assembleOf = (count: number) => `Assemble ${counted(count, "selected map", "selected maps")}`;
export const clustersBy = (axes: string) =>
  `Clusters by ${axes}: arrow keys go from one to the next, Enter selects`;
export const clusterIs = (name: string, hits: number, picked: string, map: string, error: string) =>
  `${name}, ${counted(hits, "hit", "hits")}${picked}: ${map}, ${error}`;
export const pickedAside = ", selected";
export const hitsOf = (count: number, most: string | number, least: number) =>
  `Hits of the ${count} largest clusters, from ${most} down to ${least}. The list of candidates has them in words.`;

export const numbersName = "Numbers";
export const knotsName = "Knots";
export const copiedEdges = "Copied edges";
export const bytesInLink = "Bytes in a link";
export const mapsName = "Maps";
export const featurePointsName = "Feature points";
export const widestGapName = "Widest gap";
export const allBytes = "Total bytes";
export const charactersInLink = "Characters in a link";
export const corners = "Corners";
export const together = "together";
export const apart = "apart";
export const anywhere = "anywhere";
export const brushKeys = (about: string) =>
  `${about} With the keyboard: focus the picture, move with the arrow keys, paint with the space bar, and cancel with Escape.`;
export const pinnedAside = " · pinned";
export const none = "none";
export const to = "to";
export const reads =
  "PNG, JPEG, WebP, SVG, CSV, TPS, GeoJSON, TopoJSON, or JSON from COCO, LabelMe, VIA or QuPath";
export const dragMode = "Drag mode";

export const errorAndAmount = (error: string, amount: string) => `${error} error, ${amount}`;
export const stoppedAt = (error: string, amount: string) => `Stopped: ${error} error, ${amount}`;
