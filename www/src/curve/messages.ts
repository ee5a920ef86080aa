/** What is said of closed curves. */
import { plural } from "#format/plural";

export const dimensionAlong = (a: string, b: string, low: string, high: string) =>
  `Dimension along the path: ${a} at A, ${b} at B, between ${low} and ${high}.`;
export const dimensionAtA = (dimension: string) => `A ${dimension}`;
export const shadedCrossesItself = "shaded: it crosses itself";

export const byConstruction = "by construction";
export const oneCurve = (aside: string) => `One closed curve, ${aside}`;
export const oneClosedCurve = "One closed curve";
export const oneClosedCurveBy = "One closed curve, by construction";
export const atThisMomentDoes = "At this moment it does not cross itself, checked to 1/500 of its size.";
export const mayCross = (crosses: string) =>
  `It may cross itself, which neither opens nor splits it. At this moment it ${crosses}, checked to 1/500 of its size.`;

export const twoShapes = "The two shapes";
export const swapped = (a: string, b: string) => `Swapped: from ${a} to ${b}.`;
export const systems = "Systems";
export const morphFromFernTo = "A morph from a fern to B, edge by edge, in one piece along the whole path";
export const fromFernToB = "From a fern to B";
export const closedWith = (size: string) => `closed curve with ${size}`;
export const knots = (count: number) => `${count} knots`;
export const moreFor = (shape: string) => `More for shape ${shape}`;
export const chooseAnother = "Choose another …";
export const alsoAs = (shape: string) => `Use as ${shape} too`;
export const bothShapes = (name: string) => `${name} is now both shapes.`;
export const knots2 = "Knots";
export const copies = "Copies";
export const dimension = "Dimension";
export const closedAlongWholePath = "Closed along the whole path";
export const bothEndsSameCurve =
  "Both ends are the same curve. Choose another for one of them to get a morph.";
export const now = "now";
export const roughnessAlongPath = "Roughness along the path";
export const nowCrosses = (crossings: string) => `At this moment it ${crossings}.`;
export const photos = "Photos";
export const theirPhotos = "Their photos";
export const eachPhotoFollowsOutline =
  "Each photo follows its outline, by mean value coordinates (Floater 2003; Hormann and Floater 2006), while one fades into the other. The photos stay in this browser: pictures and films show them, links and other files contain only the curves.";
export const oneColourForAll = "One colour for all copies of an arc";
export const edges = "Edges";
export const coloursAlternateFromEdge = "Colours alternate from edge to edge";
export const plain = "Plain";
export const oneColour = "One colour";
export const edgesOneColourCopies = "Edges of one colour are copies of one arc. The rest is straight.";
export const eachCopyHasDifferent =
  "Each copy has a different colour from the one before. The rest is straight.";
export const colour = "Colour";
export const colourBy = "Colour by";

export const yourShapes = "Your shapes";
export const yours = "Yours";
export const cannotUse = (name: string, problem: string) => `${name} cannot be used: ${problem}`;
export const nameOf = (name: string) => `Name of ${name}`;
export const renamedTo = (name: string) => `Renamed to ${name}.`;
export const rename = (name: string) => `Rename ${name}`;
export const remove = (name: string) => `Remove ${name}`;
export const wasRemoved = (name: string) => `${name} was removed.`;

export const shapesMaps = "Shapes of maps";

export const saveThisMoment = "Save this moment";

export const yourLatestFit = "Your latest fit.";
export const shapeAsNow = "Shape A as it is now.";
export const shapeBAsNow = "Shape B as it is now.";
export const withGrid = (name: string) => `${name}, with the grid around it.`;
export const shapeNow = (shape: string, name: string) => `Shape ${shape} is now ${name}.`;
export const closedCurves = "Closed curves";
export const outlinesMadeSmallerCopies =
  "Outlines made of smaller copies of their own arcs. They always stay closed and in one piece.";
export const outlinesMorphOnlyInto =
  "Outlines morph only into outlines, so the other shape becomes one, too.";

export const closedCurveByFrond =
  "A closed curve by Frond: at s it is between a (0) and b (1). Maps are [a, b, c, d, e, f]: x' = a x + b y + e, y' = c x + d y + f; y points up. Each map takes the arc of `span` edges that starts at knot `from` (counted from 0) to its edge.";

export const thereNoCurve = "There is no curve.";

export const outlineAsPathFor = "The outline as a path, for drawing programs and cutters";
export const pictureOnStageLarger = "The picture on the stage, larger";
export const pointsOutlineXAnd = "Points of the outline, x and y";
export const bothCurvesWithTheir = "Both curves with their knots and copies, and the outline between them";
export const curveFailed = (problem: string) => `The curve could not be saved: ${problem}`;
export const fromTo = (a: string, b: string) => `${a} to ${b}`;

export const crossesItselfOnce = "crosses itself once";
export const crossesItselfTwice = "crosses itself twice";
export const crossesTimes = (count: number) => `crosses itself ${count} times`;
export const everyEdgeStraightOr =
  "Every edge, straight or a smaller copy of an arc, runs from one knot to the next, and the last edge ends at the first knot.";
export const alsoBetween = (a: string, b: string) =>
  ` The same is true at every moment between ${a} and ${b}: the knots move and the edges follow.`;
export const nowhereApart = (edges: string, between: string) =>
  `${edges} So it cannot come apart anywhere.${between}`;
export const crossesMost = (crossing: string) =>
  `An outline made of smaller copies of its own arcs. It stays one closed curve, but at its worst moment it ${crossing}, so parts of it overlap.`;
export const outlineMadeSmallerCopies =
  "An outline made of smaller copies of its own arcs. Knots move, edges follow, and nothing can come apart.";
export const soFewKnotsHave =
  "So few knots have partners that one outline shrinks while the other grows. The usual reason is a stalk on one of them: Fit removes it in step 1 for photos.";
export const knotsBetween = (count: number) => `${count} knots during the morph.`;
export const everyKnotHasPartner = "Every knot has its partner.";
export const knotsMet = (count: number, rest: string) => `${count} knots of A become knots of B. ${rest}`;

export const outlinesOnly = (words: string) => `${words} Outlines morph only into outlines.`;
export const otherKnots = (count: number) =>
  plural(count, {
    one: "The other knot grows out of an edge or shrinks into one.",
    other: `The other ${count} knots grow out of an edge or shrink into one.`,
  });
