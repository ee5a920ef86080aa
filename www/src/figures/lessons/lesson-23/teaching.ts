import type { Teaching } from "../frame/teaching";

export const TEACHING: Teaching = {
  aim: "To find maps for a given shape by covering it with copies of itself, and to know how well that must turn out.",
  mistakes: [
    "“What the maps make is exactly as good as the collage.” It may be worse: its pieces are copies of itself.",
    "“Large copies are better, since few of them cover the leaf.” The larger they are, the less is promised.",
    "“The promise says how far it is off.” It only says that it is not farther off; mostly it is much nearer.",
  ],
  questions: [
    {
      ask: "A collage is 2 mm off and its largest copy is 3/4 as large as the leaf. What is promised?",
      answer: "At most 8 mm: 2 / (1 − 3/4).",
    },
    {
      ask: "What is promised when the copies cover the leaf perfectly?",
      answer: "0 / (1 − s) = 0: the leaf is the shape of these maps itself.",
    },
    {
      ask: "One copy as large as the leaf covers it perfectly. Why is that no solution?",
      answer: "It does not shrink: with s = 1 nothing is promised, and the map does not settle any shape.",
    },
  ],
  answer:
    "At most 2 mm: 1 + ½ + ¼ + … = 2. With copies of at most s times the size it is 1 / (1 − s) times as far off as the collage.",
  solutions: [
    "Copies of size 0.6 on the three lobes, those at the sides turned by 60° and −60°, and a small one of 0.3 in the middle.",
    "0.7: 0.06 / (1 − 0.7) = 0.2.",
  ],
  onPaper: [
    {
      ask: "Draw the outline of a leaf, or put one below the paper. Cover it with four or five smaller copies of itself as well as you can. Where is it worst, and how many millimetres is that?",
      space: "squares",
      answer:
        "It depends on the leaf. Look for the place of the leaf that is farthest from all copies, and for the place of a copy that sticks out farthest: the larger distance counts.",
    },
    "same",
  ],
};
