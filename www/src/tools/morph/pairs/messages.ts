/** What is said of pairings. */
import { listOf, plural } from "#format/plural";

export const otherPairings = "Other pairings";
export const searchAgain = "Search again";
export const thereNoOtherSensible = "There is no other sensible pairing.";
export const bestFirstPairingsWithout =
  "Best first: pairings without a visible gap, then by the narrowest gap.";
export const tryingOtherPairings = "Trying other pairings";
export const searching = "Searching …";
export const doneOf = (done: number, count: number) => `${done} of ${count}`;
export const cancel = "Cancel";
export const pairings = "Pairings";

export const mirroredMaps = (maps: readonly number[]) =>
  plural(maps.length, {
    one: `Map ${listOf(maps.map(String))} is mirrored in one shape only, so it flips over and is briefly flattened to a line.`,
    other: `Maps ${listOf(maps.map(String))} are mirrored in one shape only, so each flips over and is briefly flattened to a line.`,
  });
export const otherPaths = "Other paths";

export const enterWholeNumberTurns = "Enter a whole number of turns.";
export const eachPairingHasOwn =
  "Each pairing has its own locus above. Another pairing may stay in one piece where this one breaks.";
export const mapNumber = (number: number) => `Map ${number}`;
export const becomes = "becomes";
export const extraTurns = "extra turns";

export const mapBecomes = "Which map becomes which";

export const asThey = "As they are";
export const throughFlatState = "Through a flat state";
export const anotherPairing = "Another pairing";
export const throughSymmetry = "Through a symmetry";
export const throughMirrorImage = "Through the mirror image";
export const withSmallerCopies = "With smaller copies";
export const withCopyUsedTwice = "With a copy used twice";
export const jointByJoint = "Joint by joint";
export const withShapeBMoved = "With shape B moved or rotated";
export const frondKnowsNoOther = "Frond knows no other path.";
export const paths = "Paths";
export const anotherPath = "Another path";
