import type { Teaching } from "../frame/teaching";

export const TEACHING: Teaching = {
  aim: "To say why a curve through five points may take more boxes than a line, and from which roughness on.",
  mistakes: [
    "“What looks jagged has a dimension above 1.” The ups and downs must grow without bound as one looks more closely.",
    "“The dimension depends on where the points are.” It does not, as long as they are not on one line.",
    "“A function with a graph of dimension 1.5 must have jumps.” All of these are continuous.",
  ],
  questions: [
    {
      ask: "Ten pieces of the same width, all of the same roughness: from which roughness on is the curve more than a line?",
      answer: "From 1/10: there the ten sum to 1.",
    },
    {
      ask: "Can one rough piece among straight ones make the dimension more than 1?",
      answer: "No: its roughness alone is below 1, and so is the sum.",
    },
    {
      ask: "All five points lie on one straight line and the roughness is 0.7. What does the curve look like?",
      answer:
        "It is that line: copies of a straight line that are sheared to fit between the points are straight.",
    },
  ],
  answer:
    "Beyond ¼. There the four roughnesses sum to 1; with more, the dimension is 1 + log(4s) / log 4, which is more than 1.",
  solutions: [
    "0.59 or 0.60: the dimension is 1 + log(2s) / log 2.",
    "Two pieces straight, and two of 0.7 or more in size: 0.7 + 0.7 = 1.4 is above 1.32. One alone is below 1.",
  ],
  onPaper: [
    {
      ask: "A curve through three points has two pieces, both of roughness s. Its dimension is 1 + log(2s) / log 2. Which s gives 1.25? (2 to the power of ¼ is 1.19.)",
      answer: "2s is 1.19, so s is about 0.59 or 0.6.",
    },
    {
      ask: "Which of these curves of four pieces is more than a line? Roughnesses: a) 0.2, 0.2, 0.2, 0.2; b) 0.9, 0, 0, 0; c) 0.5, −0.5, 0.5, 0. Work out the dimension of that one. (log 1.5 / log 4 = 0.29)",
      answer: "The sizes sum to 0.8, 0.9 and 1.5: only c, whose dimension is 1.29.",
    },
  ],
};
