/** What is said of graphs. */
import { counted } from "#format/plural";

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

export const assembleOf = (count: number) => `Assemble ${counted(count, "selected map", "selected maps")}`;
export const clustersBy = (axes: string) =>
  `Clusters by ${axes}: arrow keys go from one to the next, Enter selects`;
export const clusterIs = (name: string, hits: number, picked: string, map: string, error: string) =>
  `${name}, ${counted(hits, "hit", "hits")}${picked}: ${map}, ${error}`;
export const pickedAside = ", selected";
export const hitsOf = (count: number, most: string | number, least: number) =>
  `Hits of the ${count} largest clusters, from ${most} down to ${least}. The list of candidates has them in words.`;

export const none = "none";
export const to = "to";
