/** What is said of a verdict and its proof. */
import { counted } from "#format/plural";

export const widestGap = "Widest gap";
export const keepMarksOnPicture = "Keep the marks on the picture";
export const saveDrawingSvg = "Save the drawing (SVG)";
export const fromToAt = (a: string, b: string, percent: string) => `${a} to ${b}, ${percent}`;
export const drawingFailed = (problem: string) => `The drawing could not be saved: ${problem}`;
export const descriptionPicture = "Description of the picture";
export const howNumbersInterpreted = "How the numbers are interpreted";
export const notExact = (values: string) =>
  `The stored decimals are only close to these values, so this is not a proof for them. Read as: ${values}.`;
export const aboutExact = "The proof is about the exact numbers.";
export const checkElsewhere = "To check the file yourself:";
/** What anybody can run who has Node. */
export const checkCommand = (file: string) => `npx frond-ifs check ${file}`;
export const useExact = "Use the exact values";
export const exactUsed = (values: string) => `The maps now mean ${values} exactly.`;
export const exactNumbers = "Exact numbers";
export const analysis = "Dimension and neighbours";
export const analyzing = "Searching for neighbours …";
export const analysisFailed = (problem: string) => `The search failed: ${problem}`;
export const flatMap =
  "One of the maps flattens the plane, so Frond does not search for neighbours of its pieces.";
export const onlyAtEnds = "Frond searches for neighbours at A and at B only.";
export const notAllExact = "Frond cannot compute with all of these values, so the maps keep their decimals.";
export const openSetCondition = "Open set condition";
export const holdsProved = "holds, proved";
export const doesNotHold = "does not hold: two different words of maps give the same piece";
export const notDecidedYet = "not decided";
export const neighbours = "Neighbour types";
export const dimension = "Hausdorff dimension";
export const dimensionOfBoundary = "Dimension of the boundary";
export const equals = (exact: string, value: string) => `${exact} ≈ ${value}, proved`;
export const proved = (value: string) => `${value}, proved`;
export const atMostOf = (value: string) => `at most ${value}`;
export const openBoundary = "Open the boundary";
export const boundaryReplaces = "Replaces this shape by its boundary, a shape of several states";
export const boundaryOf = (name: string) => `Boundary of ${name}`;
export const boundaryOpened = (name: string) => `${name} is open. It consists of several states.`;
export const undo = "Undo";
export const innerPoints = "Inner points";
export const yes = "yes, proved";
export const no = "no, proved";
export const nothingFound =
  "Frond found nothing that it can prove: the maps are not similarities, or pieces have too many neighbours.";
export const wherePiecesTouch = "Where the pieces touch";
export const moreLinks = (count: number) => `And ${count} more of this kind.`;
export const whyProof = "Why that is a proof";
export const piecesConnected = "Which pieces are connected";

export const downloadProof = "Download the proof";
export const checkProof = "Check the proof";
export const writingAndCheckingProof = "Writing and checking the proof …";
export const noProof = (why: string) => `No proof is available. ${why}`;
export const checksEveryContactBetween = "Checks every contact between pieces.";
export const checksAllPiecesOn = "Checks that all pieces on either side of the gap are apart.";
export const proofFailed = (problem: string) => `The proof could not be saved: ${problem}`;

export const fromToOnPath = (a: string, b: string, percent: string) => `${a} to ${b}, ${percent} of the path`;

export const drawingAbout = (words: string, pieces: string) =>
  `${words} ${pieces} of the shape. Made by Frond.`;

export const proofOneUsedFor =
  " The proof is the one used for the locus: enough pieces cross or share points.";
export const onePiece = (how: string) =>
  `From each piece you can reach every other without a jump, at any magnification.${how}`;
export const touching = (fine: string) =>
  `Its pieces come within ${fine} of its diameter of each other, so no gap is visible at that resolution. It is not proved that they meet.`;
export const narrowGap = (fine: string) =>
  ` The gap is narrower than ${fine} of the diameter, so a picture with that many pixels does not show it.`;
export const inPieces = (narrow: string) =>
  `At every magnification, nothing bridges the gap between these clusters of pieces.${narrow} Frond does not count the parts: each piece is a copy of the full shape, and may be in pieces itself.`;
export const undecided = (pairs: string) =>
  `After ${pairs} pairs of pieces, Frond has neither found a gap nor ruled one out at this resolution.`;
export const togetherTheseMapsDo =
  "Together these maps do not contract. Points wander off and never settle on a shape.";
export const shareOf = (share: string) => `${share} of the diameter: `;
export const inUnitsPlane = "in units of the plane";
export const exactly = (share: string, gap: string, unit: string) => `${share}${gap} ${unit}`;
export const between = (share: string, low: string, high: string, unit: string) =>
  `${share}between ${low} and ${high} ${unit}`;
export const atMost = (share: string, gap: string, unit: string) => `at most ${share}${gap} ${unit}`;
export const range = (from: number, to: number) => `${from} to ${to}`;
export const piecePair = (first: number, second: number) => `Pieces ${first} and ${second}`;
export const cross = (pieces: string, first: string, second: string) =>
  `${pieces} cross: a path through copy ${first} must meet one through copy ${second}.`;
export const difference = (pieces: string) =>
  `${pieces} meet: the step from one to the other is the difference of two points of such a piece.`;
export const overlapOnLine = (pieces: string) =>
  `${pieces} overlap on the line that contains the full shape.`;
export const area = (pieces: string | number) =>
  `${pieces}: their area factors add up to 1 or more, so the pieces cannot avoid each other.`;
export const sharePoint = (pieces: string, point: string, first: string, second: string) =>
  `${pieces} share the point (${point}), address ${first} = ${second}.`;
export const addressShort = (address: string, written: string) =>
  `${address} is short for ${written}…: each digit is a piece inside the previous one.`;
export const checkFailed = (text: string) => `The check failed: ${text}`;
export const contactsVerified = (contacts: string, levels: string) =>
  `Verified in exact arithmetic: ${contacts}, pieces ${levels}.`;
export const pairsVerified = (pairs: string, levels: string) =>
  `Verified in exact arithmetic: ${pairs} of pieces, ${levels}.`;

export const piecesMeeting = (pairs: string) => `Which pieces meet: ${pairs}`;
export const pairWith = (first: number, second: number) => `${first} with ${second}`;
export const none = "none";
export const piecesDrawn = (count: number) => (count === 1 ? "One piece" : counted(count, "piece", "pieces"));
export const contacts = (count: number) => counted(count, "contact", "contacts");
export const pairs = (count: number) => counted(count, "pair", "pairs");
export const levels = (deepest: number) => (deepest === 1 ? "at level 1" : `up to level ${deepest}`);
