/** What the greeting, the tour and the help say. */

export const stepOf = (number: number, count: number) => `${number} of ${count}`;
export const done = "Done.";
export const back = "Back";
export const finish = "Finish";
export const next = "Next";
export const goToLessons = "Go to the lessons";
export const skip = "Skip";

export const takeTour = "Take the tour";
export const learnFromBeginning = "Learn from the beginning";
export const glossary = "Glossary";
export const lessonOn = (word: string) => `Lesson on “${word}”`;
export const lesson = "Lesson";

export const welcome = "Welcome";
export const learn = "Learn";
export const close = "Close";
export const frondTurnsOneFractal = "Frond turns one fractal into another without letting it fall apart.";
export const turnsInto = (a: string, b: string) => `${a} turns into ${b}.`;
export const nowPressPlayTo = (b: string) => `Now it is ${b}. Press play to watch it again.`;
export const pressPlayToWatch = (a: string, b: string) => `Press play to watch ${a} turn into ${b}.`;
export const eachColourSmallerCopy = "Each colour is a smaller copy of the full shape.";

export const tourOver = "The tour is over.";
export const backToSharedLink = "Back to the shared link";

export const pressPlay = "Press play";
export const turnsIntoBFrond =
  "A turns into B. Frond has chosen a path along which the shape stays in one piece.";
export const nowTryStraightPath = "Now try the straight path";
export const chooseStraightShortestPath =
  "Choose Straight: the shortest path between the same two shapes. The timeline below the picture marks where the shape falls apart.";
export const locusShowsWhy = "The locus shows why";
export const everyPointShapeBetween =
  "Every point is a shape between A and B. Where it is pale, the shape stays in one piece; where it is dark, it is in pieces. The straight path crosses the dark.";
export const goAround = "Go around";
export const chooseAutoAndFrond =
  "Choose Auto and Frond finds a path around the dark. Or drag the path’s points yourself.";
export const askWhy = "Ask why";
export const thisSaysWhatKnown =
  "This says what is known about the shape right now. Press it to see why. Proofs can be checked by a separate program.";
export const madeWithFrond = "Made with Frond, a studio for shapes made of smaller copies of themselves.";
export const pressPlayToMove = "Press play to see it move.";
