import type { Teaching } from "../frame/teaching";

export const TEACHING: Teaching = {
  aim: "To read a dimension off a count of boxes, and to work it out from the scales of the maps.",
  mistakes: [
    "“The dimension says how large a shape is.” It says how the count of boxes grows when they get finer.",
    "“A dimension above 1 means an area.” The gasket has dimension 1.585 and no area at all.",
    "“Moran's equation always gives the dimension.” Where pieces overlap it only says that it is not more.",
  ],
  questions: [
    {
      ask: "Boxes are made three times finer, and a shape needs nine times as many. What is its dimension?",
      answer: "2, as 3 to the power of 2 is 9.",
    },
    { ask: "Which scale must two maps have for dimension 1/2?", answer: "A quarter: 2 · (1/4)^(1/2) = 1." },
    {
      ask: "Koch's curve has four maps of scale 1/3. Is it nearer to a line or to a square?",
      answer: "To a line: log 4 / log 3 = 1.26.",
    },
  ],
  answer: "Three times as many. 2 to the power of 1.585 is 3: that is its dimension.",
  solutions: [
    "¼: two copies, and 2 · √¼ = 1.",
    "½: the pieces meet in single points, and the dimension is log 3 / log 2 = 1.585. With less they are apart, with more they overlap.",
  ],
  onPaper: [
    "same",
    {
      ask: "Draw a square of 9 by 9 small squares. Leave out the middle block of 3 by 3, and the middle square of each other block. How many blocks are left, and how many squares? How does the count grow when boxes get three times finer, and is the dimension nearer to 1 or to 2?",
      space: "squares",
      answer: "8 blocks and 64 squares: eight times as many. 3 to the power of 1.893 is 8: nearer to 2.",
    },
  ],
};
