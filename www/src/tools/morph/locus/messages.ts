/** What is said of the locus and the path on it. */

export const pictureWithAxesPng = "Picture with axes (PNG)";
export const drawingWithAxesSvg = "Drawing with axes (SVG)";
export const tableCsv = "Table (CSV)";
export const arrayForNumpyNpy = "Array for NumPy (.npy)";
export const pathAloneSvg = "The path alone (SVG)";
export const whereMorphStaysIn = "Where the morph stays in one piece";
export const enlargeLocus = "Enlarge the locus";
export const saveLocus = "Save the locus";

export const locusOverUTo =
  "Locus over u, to the right, and v, upwards: pale where the shape stays in one piece, dark where it is in pieces.";
export const locusOverSReal =
  "Locus over s, real part to the right, imaginary part upwards: pale where the shape stays in one piece, dark where it is in pieces.";
export const clickLocusOrHold = "Click the locus, or hold Ctrl, to zoom with the wheel";

export const around = "Around";
export const around0CopiesRotate = "Around 0: the copies rotate and keep their size";
export const outwards = "Outwards";
export const awayFrom0Copies = "Away from 0: the copies grow and keep their rotation";
export const spiral = "Spiral";
export const intoLastLandmarkYou =
  "Into the last landmark you visited, around which M repeats itself at every step";
export const pathS = "Path of s";

export const landmarks = "Landmarks";
export const forRealSShape = "For real s the shape becomes connected at";
export const known = "known";
export const computedHere = "Computed here";
export const computing = "computing …";
export const stillComputing = "still computing …";

export const onCircleAround = "on the circle around 0";
export const angleSAround0 = "Angle of s around 0";
export const degrees = (degrees: number) => `${degrees} degrees`;
export const onRayFrom0 = "on the ray from 0";
export const sizeS = "Size of s";
export const onSpiralInto = "on the spiral into a landmark";
export const stepsSIntoLandmark = "Steps of s into the landmark";
export const stepOf = (step: string, count: number) => `step ${step} of ${count}`;
export const sIs = (s: string) => `s = ${s}`;

export const twoCopiesItself = "two copies of itself";
export const copiesOnPolygon = (count: number) => `${count} copies of itself at the corners of a polygon`;
export const paleSetCalledM = " The pale set is called M.";
export const pointIs = (copies: string, name: string) =>
  `Every point s is a shape made of ${copies}, each |s| times as large and rotated by the angle of s. It is pale where the shape is in one piece.${name}`;
export const alwaysOutside = (sides: number) =>
  `For |s| > 1/√${sides} it is always in one piece: the pieces are too large to lie apart.`;
export const someMeetOutside = (sides: number) =>
  `For |s| > 1/√${sides} some pieces must meet: they are too large to lie apart.`;
export const neverInside = (sides: number) =>
  `For |s| < 1/${sides} it never is: its dimension is below 1, too small for a connected set.`;
export const betweenTwoCirclesNo =
  "Between the two circles no formula is known, so Frond computes every sample.";
export const oppositeSameShape = "s and −s give the same shape, and s̄ its mirror image.";
export const sameShapes = (sides: number) =>
  `Rotating s by 1/${sides} of a turn gives the same shape, and s̄ gives its mirror image.`;

export const bandtGelbrich1994Apart =
  "Bandt & Gelbrich (1994): apart from the rectangle, the two twin dragons are the only such tiles of two copies";
export const onlyPowerSeriesWith =
  "the only power series with coefficients 1, 0 and −1 that vanishes there, computed here, so the two pieces share one point. On such series: ";
export const bandt2002MRepeats = "Bandt (2002). That M repeats itself around such points: Solomyak (2005)";
export const twinDragon = "Twin dragon";
export const twinDragonAbout = "s = 1/2 + i/2: the twin dragon, which tiles the plane";
export const tameDragon = "Tame dragon";
export const tameDragonAbout = "s = 1/4 + i √7/4: the tame twin dragon, the other one that tiles";
export const rectangle = "Rectangle";
export const rectangleAbout = "s = i/√2: a rectangle, √2 times as long as wide, like a sheet of A4 paper";
export const everyOtherSignMoves = "Every other sign moves along one side: two intervals, written in base −2";
export const realTip = "Real tip";
export const realTipAbout = "s = 1/2: a line, and the smallest real s that stays in one piece";
export const barnsleyHarrington1985 = "Barnsley & Harrington (1985)";
export const dendrite = "Dendrite";
export const dendriteAbout =
  "s ≈ 0.5957 + 0.2544 i, where 1 − 2s + 2s³ = 0: a tree, whose two pieces meet in one point";
export const slimDendrite = "Slim dendrite";
export const slimDendriteAbout =
  "s ≈ 0.6360 + 0.1069 i, where 1 − 2s + 2s⁴ = 0: a tree closer to the real tip";
export const hole = "A hole";
export const holeAbout = "s = 0.0227 + 0.703 i: in pieces, although all shapes around are in one piece";
export const firstSeenByBarnsley = "First seen by Barnsley & Harrington (1985); proved by Bandt (2002)";
export const spiralHoles = "Spiral of holes";
export const spiralAbout =
  "s ≈ 0.371859 + 0.519411 i, where 1 − 2s + 2s² − 2s⁵ + 2s⁸ = 0: ever smaller holes spiral into this point";
export const calegariKochWalker2017 = "Calegari, Koch & Walker (2017), Theorem 9.1.1";
export const realClosing = (sides: number) => `The real s at which the ${sides}-gon becomes connected`;
export const knownAndComputedHere = "Known, and computed here for comparison";

export const apply = "Apply";
export const oneTwoShapesIn =
  "One of the two shapes is in pieces, so no path can stay in one piece from end to end.";
export const doneWhat = (what: string) => `Done: ${what}`;
export const undo = "Undo";
export const tryingOtherPaths = "Trying other paths";
export const searchingForOtherPaths = "Searching for other paths …";
export const tryingOf = (done: number, count: number) => `Trying other paths: ${done} of ${count}`;
export const stop = "Stop";
export const whatThisChanges = "What this changes";
export const singleUndoStep = "A single undo step";

export const orDoubleClickPath = "or double-click the path";
export const searchingForPath = "Searching for a path …";
export const thirdNumberWHow = "A third number, w: how far the stretch leads the rotation";
export const proofPath = "Proof of the path";
export const cancel = "Cancel";
export const soFarFrondHas =
  "So far Frond has checked 241 moments. The proof covers everything between them, too";
export const tryToBoundGaps = "Try to bound the gaps of the path";
export const tryToProveWhole = "Try to prove the whole path";
export const whyProof = "Why that is a proof";

export const stretchMayLeadOr = "The stretch may lead or lag the rotation: a path through three parameters";
export const withThirdParameterSearching = "With a third parameter: searching …";
export const withThirdParameter = "With a third parameter";
export const thirdParameterDoesNot = "The third parameter does not help here.";
export const otherPairings = "Other pairings";
export const otherPaths = "Other paths";

export const worstAt = (gap: string, percent: string) => `Widest gap of the path: ${gap}, at ${percent}`;

export const thirdFailed = (problem: string) =>
  `The search for a path through three parameters failed: ${problem}`;

export const breaksOnPathBefore = "breaks on the path before it";
export const andAfter = "and after it";
export const breaksOnPathAfter = "breaks on the path after it";
export const mostWaypoints = (most: number) => `A path has at most ${most} waypoints.`;
export const waypointAdded = (number: number, count: number, point: string, state: string) =>
  `Waypoint ${number} of ${count} added at ${point}, ${state}.`;
export const waypointRemoved = (number: number, count: number) =>
  `Waypoint ${number} removed, ${count} left.`;

export const backToPath = "Back to the path";
export const addAsWaypoint = "Add as waypoint";
export const atPoint = (verdict: string) => `At this point: ${verdict}.`;
export const morphThenStartsWith = "The morph then starts with this shape";
export const useAs = "Use as A";
export const morphThenEndsWith = "The morph then ends with this shape";
export const useAsB = "Use as B";
export const thisShapeCouldNot = "This shape could not be created.";
export const shapeNow = (end: string, name: string) => `Shape ${end} is now ${name}.`;
export const showMorph = "Show the morph";

export const arrowKeysMoveCross =
  "Arrow keys move the cross, with Shift finer, with Alt farther. Plus and minus zoom, 0 resets. ";
export const enterShowsShapeThere = "Enter shows the shape there. A makes it a waypoint.";
export const pictureNowShowsThis = "The picture now shows this shape.";

export const inOnePieceProved = "In one piece, proved";
export const noGapSeenAt = "No gap seen at this resolution";
export const inPiecesByGap = "In pieces, by a gap too narrow to see";
export const notDecided = "Not decided";
export const noAttractor = "No attractor";
export const inPiecesByFronds = "In pieces, by Frond’s own bounds";
export const areas = (count: number) => `${count} areas`;
export const path = "the path";
export const axesFromTo = (across: string, u0: number, u1: number, up: string, v0: number, v1: number) =>
  `${across} from ${u0} to ${u1}, ${up} from ${v0} to ${v1}`;
export const madeBy = (facts: string) => `${facts}. Made by Frond.`;

export const locusHasNotBeen = "The locus has not been computed yet. Wait a moment.";
export const locusNotCompleteYet = "The locus is not complete yet: the file leaves undecided samples blank.";
export const locusNotSaved = (problem: string) => `The locus could not be saved: ${problem}`;
export const polygonsOf = (sides: number) => `Polygons with ${sides} sides`;
export const fromTo = (a: string, b: string) => `${a} to ${b}`;
export const browserCouldNotCreate = "The browser could not create a canvas.";

export const whySomeNotProved = "Why some of it is not proved";
export const allPaleAreaProved = "All of the pale area is proved.";
export const checkingMoreClosely = "Checking more closely …";
export const checkingCauses = (done: number, count: number) =>
  `Checking more closely: ${done} of ${count} samples.`;
export const causesOf = (count: number) => `A closer check of ${count} samples that are not proved:`;

export const familyShapes = "Family of shapes";
export const thisMorph = "This morph";
export const allCanLieBetween = "All that can lie between the two shapes";
export const pairsM = "Pairs (M)";
export const shapesTwoCopiesRotated = "Shapes of two copies, rotated and shrunk by s: {s z − 1, s z + 1}";
export const polygons = "Polygons";
export const copiesAtCornersPolygon = "Copies at the corners of a polygon, all rotated and shrunk by s";
export const corners = "Corners";
export const enterWholeNumber = "Enter a whole number.";

export const thirdParameter = "Third parameter:";
export const leadsBy = (w: string) => `w = ${w}`;
export const wLabel = "Stretch leads rotation by w";
export const wTogether = "0: stretch and rotation together";
export const wField = "stretch leads rotation by w";
export const showLocusThere = "Show the locus there";

export const countedIn = (unit: string) => `counted in units of ${unit}`;
export const n64BitNumbersEnd = "64-bit numbers end here";
export const ofDiameter = (epsilon: string) => `ε ${epsilon} of the diameter`;

export const uRotate = "u rotate";
export const moveV = "move v";

export const nearestBoundary = (direction: string) => `To the nearest border, ${direction}`;
export const toBoundary = (distance: string, direction: string) => `To the border, ${distance} ${direction}`;
export const noBoundary = (resolution: string) =>
  `Frond found no border: what shows no gap here at the usual resolution is in pieces at ${resolution}.`;
export const atBorder = "At the border.";

export const axisRange = (axis: string, from: string, to: string) => `${axis} ${from} to ${to}`;
export const centreLabel = "Centre";
export const zoom = "Zoom";
export const showShapeAt = "Show the shape at";
export const and = "and";

export const backToPanel = "Back to the panel";
export const fullScreen = "Full screen";
export const zoomIn = "Zoom in";
export const orClickLocusAnd = "or click the locus and turn the wheel, or double-click";
export const zoomOut = "Zoom out";
export const resetView = "Reset the view";

export const allInPieces = (source: string) => `All of this is in pieces, ${source}.`;
export const allThisInOne = "All of this is in one piece, proved.";
export const allNoGap = (resolution: string) => `No gap above ${resolution} seen anywhere here`;
export const partProved = (noGap: string, part: string) =>
  `${noGap}. For ${part} of it, one piece is proved.`;
export const toRight = "to the right";
export const upAndToRight = "up and to the right";
export const upAndToLeft = "up and to the left";
export const toLeft = "to the left";
export const downAndToLeft = "down and to the left";
export const downAndToRight = "down and to the right";

export const narrowerGap = (resolution: string) => `in pieces, by a gap under ${resolution} of its size`;
export const inOnePieceLonger = "in one piece: a longer search proves it";
export const sharingPointsIfDecimals =
  "sharing points if the decimals stand for the numbers nearby, which the decimals alone do not prove";
export const stillNoGap = (resolution: string) => `no gap at ${resolution} either, and no proof`;
export const stillOpen = (resolution: string) => `not decided at ${resolution}`;

export const thisBrowserDoesNot =
  "This browser does not allow full screen here. The locus fills the page instead.";

export const viewProblem = (problem: string) =>
  `This part of the locus cannot be shown: ${problem}. Frond shows all of it instead.`;

export const plusMinus = (half: string) => `± ${half}`;
export const stretchNeedNot =
  "Stretching and rotation need not go together. Here the square shows the morphs whose stretch leads their rotation by w.";
export const pictureElsewhere = (w: string) => `The picture is at w = ${w}, which is not on this slice.`;
export const inUnits = (unit: string) => `, in units of ${unit}`;
export const touchingWithin = (resolution: string) =>
  `Pieces within ${resolution} of the shape’s diameter count as touching.`;
export const finestTouching = (resolution: string) =>
  `Pieces within ${resolution} of the shape’s diameter count as touching: 64-bit numbers allow no finer distinction.`;
export const rotateAndShrink = "rotate and shrink by";
export const rotateAndStretch = "rotate and stretch";
export const move = "move";
export const nameAt = (name: string, s: string) => `${name} at ${s}`;
export const gon = (sides: number) => `${sides}-gon`;
export const stretchLead = "stretch lead";
