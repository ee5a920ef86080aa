import type { Teaching } from "../frame/teaching";

export const TEACHING: Teaching = {
  aim: "To say what it means that a map shrinks, and why any factor below 1 is enough and 1 is not.",
  mistakes: [
    "“0.99 is nearly 1, so hardly anything happens.” In the long run only that it is below 1 counts.",
    "“At scale 1 the points still come nearer, only slowly.” They stay exactly as far apart as they are.",
    "“After enough steps the distance is 0.” It gets below any length that one names, and is never 0.",
  ],
  questions: [
    {
      ask: "A map has scale 0.9. After how many steps is every point nearer to the middle than half of what it was?",
      answer: "After 7: 0.9 to the power of 7 is 0.478, to the power of 6 it is 0.531.",
    },
    {
      ask: "Why can no bounded shape of more than one point be a copy of itself by a map of scale 2?",
      answer:
        "Two of its points as far apart as any would have copies twice as far apart, within the same shape.",
    },
    {
      ask: "Which number stays where it is if one takes a third of it and adds 4?",
      answer: "6: a third of it is 2, and 2 + 4 = 6.",
    },
  ],
  answer:
    "Less than a tenth of a millimetre: 0.99 to the power of 1000 is 0.000043, so 0.043 millimetres are left of a metre.",
  solutions: [
    "0.93: its tenth power is 0.484, and that of 0.94 is 0.539.",
    "6: half of it is 3, and 3 + 3 = 6.",
  ],
};
