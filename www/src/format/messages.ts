/** Numbers, verdicts and descriptions in words. */
import { counted, plural } from "./plural";

export const edgeIRunsFrom =
  "Edge i runs from knot i to the next. It is straight (null), or a copy of the arc over `span` edges from knot `from`: map is [a, b, c, d, e, f], x' = a x + b y + e, y' = c x + d y + f. Indices count from 0; y points up.";
export const percentDiagonalOutlinesBounding = "percent of the diagonal of the outline's bounding box";
export const closedCurveNodeOn =
  "A closed curve. A node `on` the curve is a corner; any other node is the middle control point of a parabola (a quadratic Bézier segment). Two such nodes in a row have a joint halfway between them. `word` is the whole curve in base 64 (URL-safe), of so many `bytes`. y points up.";

export const typeNumberSuchAs = "Type a number such as 0.5, 1/3 or √3/2.";
export const bracketStillOpenEach = "A bracket is still open: each ( needs a ).";
export const thereWithout = "There is a ) without a (.";
export const chooseBaseWriteLn = "Choose a base: write ln, log2 or log10.";
export const unknownInNumber = (token: string) =>
  `A number cannot contain “${token}”. Known names: sqrt, sin, cos, tan, exp, ln, abs, pi and e.`;
export const tooLong = (hint: string) => `${hint} This is too long.`;
export const resultTooLargeDivides =
  "The result is too large, divides by zero, or takes the root of a negative number.";

export const bothExact = (method: string) => `Exact, like the next best method (${method}).`;
export const exactBut = (method: string, error: string) =>
  `Exact. The next best method (${method}) is off by ${error}.`;
export const timesAsAccurate = (ratio: string, method: string) =>
  `${ratio} times as accurate as the next best (${method}).`;
export const aboutAsAccurate = (method: string) => `About as accurate as the next best (${method}).`;
export const lessAccurate = (method: string, error: string) =>
  `Here another method is more accurate: ${method}, ${error}.`;

export const atLeast = (least: string) => `Enter at least ${least}.`;
export const atMost = (most: string) => `Enter at most ${most}.`;

export const becomes = (from: number, to: number) => `${from} becomes ${to}`;
export const sameNumbers = "each keeps its number";
export const changePartner = (moved: number, count: number) => `${moved} of ${count} maps change partner`;
export const halfTurnOfOne = (map: string, now: string, other: string) =>
  `Map ${map} makes exactly half a turn, ${now}. Half a turn ${other} is just as short.`;
export const halfTurnOfSeveral = (maps: string) =>
  `Maps ${maps} make exactly half a turn, which is equally short in either direction.`;
export const noGapOnPath = "no gap seen anywhere";
export const noAttractorOnPath = "no attractor somewhere on the path";
export const gapOf = (share: string) => `gap ${share}`;
export const runsRightAlongBorder = "It runs right along the border.";
export const keepsAway = (distance: string) =>
  `It keeps a distance of ${distance} from where the shape breaks.`;
export const notProved = (problem: string) => `The path could not be proved. ${problem}`;
export const proving = (part: string) => `Proving: ${part} of the path so far.`;
export const jointsProved = (joints: number, gap: string) =>
  `Proved for every moment of this path: each piece meets the next in one of ${joints} joints. All joints stay joined, up to rounding (${gap} of the shape’s diameter).`;
export const proofTooLong = (place: string, steps: string) =>
  `The whole path could not be proved: at ${place} the proof would take more than ${steps}.`;
export const pathProved = (steps: string) =>
  `In one piece, proved for every moment of this path, in ${steps}.`;
export const gapsBounded = (steps: string, gap: string, place: string) =>
  `Proved in ${steps}: no moment of this path has a gap wider than ${gap} of the shape’s diameter. Between the sampled moments narrower gaps are still possible; the widest would be near ${place}.`;
export const checkingPath = "Checking the path …";
export const soFar = " so far";
export const widestGap = (gap: string, source: string) => `, widest gap ${gap}, ${source}`;
export const gapUnder = (gap: string, least: string) => `, gap ${gap}, under ${least} of its size`;
export const someGapUnder = (least: string) => `, gap under ${least} of its size`;
export const lessThanOne = "less than 1%";
export const atMoment = (moment: number) => `at ${moment}%`;
export const between = (from: number, to: number) => `between ${from}% and ${to}%`;
export const morePlaces = (count: number) => `in ${count} more places`;

export const changeWithNoSimple = "a change with no simple description";
export const scaledBy = (factor: string) => `scaled by ${factor}`;
export const rotatedBy = (angle: string, axis: string) => `rotated by ${angle}° about ${axis}`;
export const movedBy = (shift: string) => `moved by (${shift})`;
export const andAlsoShearedOr = "and also sheared or mirrored";
export const noNumberGrowsEvery = "No number grows: every map keeps the direction.";
export const row = (row: number) => `row ${row}`;
export const cell = (row: number, column: number) => `row ${row}, column ${column}`;
export const cellOf = (cell: string, map: string) => `${cell} of w${map}`;
export const andMore = (more: number) => ` and ${more} more`;
export const inColumn = (ordinal: string) => `, in the ${ordinal} column`;

export const addressRead = (text: string, address: string, first: string, then: string) =>
  `${text} (${address} means: piece ${first}, in it part ${then}, in that part ${then} again, and so on.)`;

export const singlePoint = "a single point";
export const onHorizontal = (length: string) => `on a horizontal line ${length} long`;
export const onVertical = (length: string) => `on a vertical line ${length} long`;
export const widthAndHeight = (width: string, height: string) => `${width} wide and ${height} high`;
export const oneSize = (copies: string, factor: string) => `${copies}, ${factor} times as large`;
export const eachSize = (copies: string, factor: string) => `${copies}, each ${factor} times as large`;
export const sizesBetween = (copies: string, least: string, most: string) =>
  `${copies}, from ${least} to ${most} times as large`;
export const equilateralTriangle = "an equilateral triangle";
export const square = "a square";
export const regularPentagon = "a regular pentagon";
export const regularHexagon = "a regular hexagon";
export const regularOctagon = "a regular octagon";
export const hasSymmetries = (polygon: string) => `It has the symmetries of ${polygon}.`;
export const verticalLine = "a vertical line";
export const horizontalLine = "a horizontal line";
export const lineAt = (angle: string) => `a line at ${angle}°`;
export const mirrored = (lines: string) => `is its own mirror image across ${lines}`;
export const looksSameUpsideDown = "looks the same upside down";
export const rotated = (angle: string) => `looks the same when rotated by ${angle}°`;
export const itDoes = (facts: string) => `It ${facts}.`;
export const pair = (first: number, second: number) => `${first} and ${second}`;
export const copiesTouchOrOverlap = "Copies that touch or overlap";
export const copiesComeCloseOr = "Copies that come close or touch";
export const pairCount = (what: string, count: number) => `${what}: ${count} pairs.`;
export const inOnePiece = "It is in one piece.";
export const noGapVisible = "No gap is visible.";
export const moreParts = (count: number) => `more than ${count} parts`;
export const parts = (count: number) => `${count} parts`;
export const inPieces = (parts: string) => `It is in pieces: a small picture shows ${parts}.`;
export const inPiecesOnly = "It is in pieces.";
export const notKnownWhetherIn = "It is not known whether it is in one piece.";
export const mapsDoNotContract = "Its maps do not contract together, so there is no shape.";
export const smallPictureShowsNo = "A small picture shows no holes.";
export const moreHoles = (count: number) => `A small picture shows more than ${count} holes.`;

export const byFrondsOwnBounds = "by Frond’s own bounds";
export const inOnePieceProved = "In one piece, proved";
export const under = (resolution: string) => `, under ${resolution} of its size`;
export const gapIs = (share: string, under: string) => `gap ${share}${under}`;
export const inPiecesProved = "In pieces, proved";
export const inPiecesText = "In pieces";
export const notDecided = "Not decided";
export const decidingWouldTakeToo = "deciding would take too long";
export const noAttractor = "No attractor";
export const mapsDoNotContractTogether = "the maps do not contract together";
export const checking = "Checking …";

export const stretchThenLeadsOr = "The stretch then leads or lags the rotation.";
export const narrowerGap = (gap: string, now: string) =>
  `Another path has a narrower gap: ${gap}, not ${now}.`;
export const upToRounding = ", up to rounding";
export const keepsInOnePiece = (change: string, limit: string) =>
  `${change} keeps the morph in one piece${limit}.`;
export const thirdParameter = "A third parameter";
export const rotating = (shape: string, degrees: number) => `rotating ${shape} by ${degrees}°`;
export const moving = (shape: string) => `Moving ${shape}`;
export const anotherPath = "Another path";
export const bothChanges = (first: string, second: string) => `${first} and ${second}`;
export const pairingJointByJoint = "Pairing joint by joint";
export const pairingMapsDifferently = "Pairing the maps differently";
export const usingSymmetryShape = "Using a symmetry of the shape";
export const morphingToMirrorImage = "Morphing to the mirror image";
export const splittingPiecesDifferently = "Splitting the pieces differently";
export const usingAnotherPieceTwice = "Using another piece twice";
export const couldNotSearch = (problem: string) => `Frond could not search for other paths: ${problem}`;
export const frondTriedNoOther = "Frond tried no other path.";
export const someTried = (done: number, of: number) => `${done} of ${of} other paths`;
export const allTried = (done: number) => `${done} other paths`;
export const noneStays = (paths: string) => `Frond tried ${paths}: none stays in one piece`;
export const orNarrower = (none: string) => `${none} or has a narrower gap.`;

export const someTimeAgo = "some time ago";

export const steps = (count: number) => counted(count, "step", "steps");
export const turnDifferently = (partners: string, count: number) =>
  `${partners}; ${plural(count, { one: "one turns", other: `${count} turn` })} differently`;
export const verdictAt = (verdict: string, places: string) => `${verdict} ${places}`;
export const noGapAnywhere = (resolution: string, soFar: string) =>
  `No gap above ${resolution} seen anywhere on the path${soFar}.`;
export const provedThroughout = (soFar: string) => `In one piece, proved, along the whole path${soFar}.`;
export const provedAtSamples = (soFar: string) => `In one piece, proved, at every sampled moment${soFar}.`;
export const provedAtSome = (part: string, soFar: string, resolution: string) =>
  `In one piece, proved, at ${part} of the sampled moments${soFar}. At the others no gap above ${resolution} was seen.`;
export const everyPathBreaks =
  "As far as Frond can tell, every path here breaks somewhere; this one opens the smallest gap.";
export const everyPathBreaksEvenThen =
  "As far as Frond can tell, every path breaks somewhere, even with the third parameter; this one opens the smallest gap.";
export const noPathFound =
  "Frond found no path here that stays in one piece; this one opens the smallest gap.";
export const noPathFoundEvenThen =
  "Frond found no path that stays in one piece, even with the third parameter; this one opens the smallest gap.";
export const clockwise = "clockwise";
export const counterClockwise = "counter-clockwise";

export const noComplexNumbers =
  "Complex numbers are not accepted here. Use Turn, stretch, move, or enter real parts.";

export const numbersGrow = (count: number, column: string, places: string) =>
  `${plural(count, { one: "1 number grows", other: `${count} numbers grow` })} without bound${column}: ${places}.`;
export const first = "first";
export const second = "second";
export const third = "third";

export const shapeIs = (name: string, copies: string, size: string) => `${name}: ${copies}${size}.`;
export const sizeAside = (size: string) => `, ${size}`;
export const someHoles = (count: number) =>
  `A small picture shows ${plural(count, { one: "one hole", other: `${count} holes` })}.`;
export const pairsAre = (what: string, pairs: string) => `${what}: ${pairs}.`;

export const noGapSeen = "No gap seen";
export const checkedTo = (resolution: string) => `checked to ${resolution} of its size`;
export const copies = (count: number) => plural(count, { one: "one copy", other: `${count} copies` });
