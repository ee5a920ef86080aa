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
  onPaper: [
    {
      ask: "A map has scale 0.8. Two points are 1 metre apart. Work out how far apart they are after 1, 2, 3, … steps, and draw it, a square for each tenth of a metre. After how many steps are they less than 10 centimetres apart?",
      space: "squares",
      answer:
        "0.8, 0.64, 0.512, 0.41, 0.328, 0.262, 0.21, 0.168, 0.134, 0.107, 0.086 metres: after 11 steps.",
    },
    "same",
  ],
};
