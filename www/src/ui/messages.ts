/** What the widgets say that know no tool. */

export const undo = "Undo";
export const everywhere = "Everywhere";
export const redo = "Redo";
export const openFile = "Open a file";
export const keyboardShortcuts = "Keyboard shortcuts";
export const space = "Space";

export const stays = (value: string) => `Still ${value}.`;

export const thereNothingToDraw = "There is nothing to draw yet. Wait a moment.";
export const madeBy = (about: string) => `${about} Made by Frond.`;

export const mapsAsText = "Maps as text";
export const forPapersAndOther = "For papers and other programs. Exact numbers stay exact.";
export const loading = "Loading …";
export const isCopied = (name: string, format: string) => `Copied ${name} as ${format}.`;
export const browserBlockedCopyingSave = "The browser blocked copying. Save the file instead.";
export const maps = "Which maps";
export const format = "Format";
export const nameAs = (name: string, format: string) => `${name} as ${format}`;
export const saveAs = (extension: string) => `Save .${extension}`;
export const copy = "Copy";
export const thereNoMapsHere = "There are no maps here.";
export const moreLines = (lines: string, more: string) => `${lines}\n… and ${more} more lines`;

export const browserCouldNotEncode = "the browser could not encode it.";

export const pictureCouldNotSaved = "The picture could not be saved";
export const pictureCouldNotPrinted = "The picture could not be printed";
export const drawingTo = (purpose: string) => `Drawing the picture to ${purpose} …`;
export const cancel = "Cancel";

export const rotate = "Rotate";
export const move = "Move";
export const scale = "Scale";
export const shear = "Shear";
export const any = "Any";
export const transform = "Transform";
export const backTo = (as: string) => `Back to the shape ${as}`;
export const backToDone = (as: string) => `Back to the shape ${as}.`;
export const reset = "Reset";
export const transformation = "Transformation";
export const angle = "Angle";
export const aboutAxis = (axis: string) => `About ${axis}`;
export const alongAxis = (axis: string) => `Along ${axis}`;
export const allAxes = "All axes";
export const slidesWith = (first: string, second: string) => `${first} slides with ${second}`;
export const pivot = "Pivot";
export const centre = "centre";
export const origin = "origin";

export const wholeTransformationXX = "The whole transformation: x′ = A x + b.";
export const matrixFlatSoCannot = "The matrix is flat, so it cannot be undone.";
export const sizesTimes = (sizes: string, factor: string, mirrored: string) =>
  `${sizes} times ${factor}${mirrored}`;
export const discard = "Discard";
export const movedThere = (name: string) => `The ${name} has been transformed.`;
export const staysThere = (problem: string, name: string) => `${problem} The ${name} is unchanged.`;
export const apply = "Apply";

export const parameters = "Parameters";
export const showParameters = "Show parameters";
export const now = "Now";
export const allAs = (as: string) => `All ${as}: there is no transformation.`;
export const parametersNow = "Parameters now";
export const parametersAs = (as: string) => `Parameters ${as}`;
export const notAs = (as: string) => `not ${as}`;
export const showOnly = (count: number) => `Show only ${count}`;
export const showAll = (count: number) => `Show all ${count}`;
export const samePicture = (as: string) =>
  `Drawing with these numbers gives the same picture as drawing ${as} and transforming every point.`;

export const untitled = "Untitled";
export const openNamed = (name: string) => `Open ${name}`;
export const nameOf = (name: string) => `Name of ${name}`;

export const partNotLoaded = (problem: string) => `A part of the page could not be loaded. ${problem}`;

export const map = "Map";
export const verbMap = (verb: string, number: number, number2: string | number) =>
  `${verb} ${number} (key ${number2})`;

export const applyMap = "Apply map";
export const address = "Address";
export const notKnownYet = "not known yet";
export const nextLetter = "Next digit";
export const randomMapByWeights = "A random map, by the weights of the shape";
export const randomMapEachEqually = "A random map, each equally likely";
export const throwLabel = "Throw";
export const atMostSteps = (steps: number) => `At most ${steps} steps`;
export const throws = (count: number) => `${count} throws`;
export const pause = "Pause";
export const play = "Play";
export const back = "Back";
export const startOver = "Start over";
export const useNearestPointShape = "Use the nearest point of the shape";
export const selectedPoint = "Selected point";

export const throwMap = "Throw map";
export const thrown = "Thrown";
export const nothingYet = "nothing yet";
export const newTarget = "New target";
export const showSolution = "Show a solution";
export const lettersCell = "Digits of the cell";

export const noAddress = (point: string) =>
  `Frond finds no address for the point ${point}: too many pieces overlap near it.`;
export const offShape = (point: string, distance: string) =>
  `The point ${point} is off the shape, at a distance of ${distance}. Only points of the shape have an address.`;
export const onShapeAndStays = " It is on the shape, and stays there.";
export const offButLed = (distance: string) =>
  ` It is off the shape, at a distance of ${distance}. The maps still lead it to the shape.`;
export const startsAt = (point: string, where: string) => `The point starts at ${point}.${where}`;
export const stepsFull = (count: number) => ` ${count} steps is the limit. Start over.`;
export const stepTo = (step: number, map: number, point: string, full: string) =>
  `Step ${step}: map ${map}, to ${point}.${full}`;
export const sharedPoint = (pieces: string) =>
  ` Pieces ${pieces} share the point, so it has several addresses. Frond shows the first.`;
export const onShape = (point: string, several: string) => `The point ${point} is on the shape.${several}`;
export const flatMap = (map: number) =>
  ` Map ${map} flattens the shape, so it has no inverse. Frond uses one of the points that it brings here.`;
export const moreDigitsFinerThan = " More digits are finer than numbers can distinguish.";
export const andSoOn = " and so on";
export const addressSoFar = "Address so far";
export const addressIs = (words: string, label: string, address: string, more: string) =>
  `${words} ${label}: ${address}${more}.`;
export const throwsOf = (count: number) => `${count} throws`;
export const readBackwardsThisAddress = "Read backwards, this is the address of the cell:";
export const cellHasAddress = "The cell has the address";
export const oneSolution = (order: string, why: string, address: string) =>
  `One solution: ${order}. ${why} ${address}.`;
export const throwsFull = (throws: string) => `${throws} is the limit. Start over.`;
export const noThrowYet = "No throw yet.";
export const notYet = (throws: string) => `${throws}. The point is not in the framed cell yet.`;
export const reachedButFewer = (throws: string) => `Reached in ${throws}. Fewer are possible: start over.`;
export const compareWithYourThrows = " Compare it with your throws.";
export const wellDone = (throws: string, address: string, why: string) =>
  `Well done: reached in ${throws}, the fewest possible. The cell has the address ${address}.${why}`;
export const framedCell = (width: string, centre: string, words: string, point: string) =>
  `The framed cell is ${width} wide, with its centre at ${centre}. ${words} The point is at ${point}.`;
export const cellCentre = (centre: string) => ` The centre of the cell is at ${centre}.`;
export const wordsAndPoint = (words: string, point: string, sought: string) =>
  `${words} The point is at ${point}.${sought}`;

export const close = "Close";

export const qrCodeLink = "QR code of the link";
export const linkTooLongFor = "The link is too long for a QR code. Send it as text.";

export const inNumberFieldsAnd = "In number fields: ↑ and ↓ change the value (Shift: finer, Alt: coarser).";
export const keyboard = "Keyboard";
export const help = "Help";
export const licencesFrondAndComponents = "Licences of Frond and its components";
export const or = "or";

export const notices = "Notices";
export const dismiss = "Dismiss";

export const allNowMakeOther = "All now make the other half turn.";
export const turnAllThemOther = "Turn all of them the other way";
export const mapTurnsNow = (number: number, direction: string) => `Map ${number} now turns ${direction}.`;
export const turnMap = (number: number, direction: string) => `Turn map ${number} ${direction}`;

export const shapeChoose = (letter: string, name: string, note: string) =>
  `Shape ${letter}: ${name}, ${note}. Choose another`;
export const chooseAnotherShape = "Choose another shape";
export const swapAndB = "Swap A and B";

export const parametersFlattenedShape = "Parameters of the flattened shape";
export const grows = "grows";

export const mapColon = (number: number) => `Map ${number}:`;
export const mapNumber = (number: number) => `Map ${number}`;
export const duplicateThisMap = "Duplicate this map";
export const mapCopied = (number: number, original: number) => `Map ${number} is a copy of map ${original}.`;
export const removeThisMap = "Remove this map";
export const mapRemoved = (number: number) => `Map ${number} is removed.`;

export const playOrPause = "Play or pause";
export const time = "Time";
export const backOrForwardBy = "Back or forward by 1%";
export const backOrForwardBy0 = "Back or forward by 0.1%";
export const toStop = (stop: string) => `To the ${stop} before or after`;

export const lessonOn = (name: string) => `Lesson on “${name}”`;
export const lesson = "Lesson";
export const whyProof = "Why that is a proof";

export const whatThisMeans = "What this means";

export const oneFigureMadeCopies =
  "The one figure that is made of the copies its maps make of it. In books: the attractor.";
export const ruleMakesSmallerCopy =
  "A rule that makes a smaller copy: rotated, moved, stretched or mirrored.";
export const copyFullShapeOne = "The copy of the full shape that one map makes.";
export const youCanGoFrom = "You can go from each piece to every other through pieces that share a point.";
export const reasonHoldsAtEvery =
  "The reason holds at every magnification, and a separate program can check it.";
export const piecesComeSoClose =
  "The pieces come so close that no gap shows at this resolution. It is not proved that they meet.";
export const widestStepYouCannot =
  "The widest step you cannot avoid when you walk over all pieces. It is 0 exactly when the shape is in one piece.";
export const resolutionVerdictFrondDoes =
  "The resolution ε of a verdict: Frond does not see gaps below this fraction of the shape’s size.";
export const uSaysHowFar =
  "u says how far the maps have turned and stretched from A to B, and v how far they have moved. A is at 0, 0 and B at 1, 1.";
export const pictureAllShapesBetween =
  "The picture of all shapes between A and B, one at each point: u runs to the right, v upwards. It is pale where the shape stays in one piece. In books: the connectedness locus.";
export const lineFromToB = "The line from A to B across the locus. Playing the morph follows it.";
export const locusAllShapesWith =
  "The locus of all shapes with two equal pieces, one for each complex number s with |s| < 1.";
export const digitsLeadToPiece = "The digits that lead to a piece: 13 is piece 3 of piece 1.";

export const asMade = "as made";
export const asBefore = "as before";
export const asMadeLabel = "As made";
export const asBeforeLabel = "As before";
export const mirroredToo = ", mirrored";
export const numbersChanged = (count: number, of: number, as: string) =>
  `${count} of ${of} numbers are not ${as}.`;
export const numbersUnderlined = (count: number, of: number, as: string) =>
  `${count} of ${of} numbers are not ${as} (underlined).`;
export const fixedPoint = "What stays in place";
export const digitIs = (step: number, digit: number, point: string, more: string) =>
  `Digit ${step} is ${digit}: the point lies in piece ${digit}. The inverse of map ${digit} takes it to ${point}.${more}`;
