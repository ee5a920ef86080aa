/** What the panel of a fit says. */

export const fit = "Fit";
export const points = (count: string) => `${count} points`;
export const useAs = "Use as A";
export const useAsB = "Use as B";
export const deform = "Deform it";
export const deformPhoto = "Deform its photo";
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

export const crossesItself = (times: number) =>
  `This outline crosses itself ${times === 1 ? "once" : times >= 99 ? "99 times or more" : `${times} times`}. You can fit it as it is. Smoothing removes crossings that come from noise.`;
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
export const reads =
  "PNG, JPEG, WebP, SVG, CSV, TPS, GeoJSON, TopoJSON, or JSON from COCO, LabelMe, VIA or QuPath";
export const dragMode = "Drag mode";
