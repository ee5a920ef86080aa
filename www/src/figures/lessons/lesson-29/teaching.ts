import type { Teaching } from "../frame/teaching";

export const TEACHING: Teaching = {
  aim: "To see that copies of copies need not be rough: one number leads from straight lines over a parabola to a curve without a slope.",
  mistakes: [
    "“What is made of copies of itself is jagged.” The parabola is made of two sheared, flattened copies of itself.",
    "“A smaller s is a smoother curve.” At 0 there is a corner; at ¼ there is none; between 0 and ¼ there are corners again.",
    "“Without a slope the dimension must be above 1.” At ½ there is no finite slope anywhere, and the dimension is 1.",
  ],
  questions: [
    {
      ask: "How high is the curve over one eighth, if s is ¼?",
      answer: "7/16: the parabola 4x(1 − x) has it there.",
    },
    {
      ask: "What does each step add to the area below the curve, if s is ¼?",
      answer:
        "A quarter of what the step before added: so Archimedes found the area of the parabola, 1/2 · (1 + 1/4 + 1/16 + …) = 2/3.",
    },
    {
      ask: "Why must s be below 1?",
      answer: "Each step adds s times as much as the one before: at 1 the heights would grow without bound.",
    },
  ],
  answer:
    "A smooth hill without any corner, the parabola 4x(1 − x): at ¼ each step rounds off exactly the corners that the step before has left.",
  solutions: [
    "0.50: over a quarter the height is ½ + s.",
    "0.71: the dimension is 2 + log s / log 2, and 2 to the power of −½ is 0.707.",
  ],
  onPaper: [
    "same",
    {
      ask: "Draw the tent through (0, 0), (8, 8) and (16, 0), and take s = ½. Each step puts tents onto the curve that are half as wide and half as tall as those before: first two that are 8 wide and 4 high, then four that are 4 wide and 2 high. Draw the curve after both steps.",
      space: "squares",
      answer:
        "After one step it is 0, 8, 8, 8, 0 high over 0, 4, 8, 12, 16; after two it is 0, 6, 8, 10, 8, 10, 8, 6, 0 high over 0, 2, 4, …, 16.",
    },
  ],
};
