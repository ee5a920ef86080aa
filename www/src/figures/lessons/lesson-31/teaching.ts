import type { Teaching } from "../frame/teaching";

export const TEACHING: Teaching = {
  aim: "To lead a point into any cell by choosing throws, and to see that the throws are the address of the cell, read backwards.",
  mistakes: [
    "“Throw towards the cell.” The nearest corner is right for the last throw only: the throws before it prepare the place.",
    "“Throw the address from its first letter to its last.” Each throw puts its number in front, so the first letter is thrown last.",
    "“From another start it takes other throws.” Where one starts is forgotten by half with every throw.",
  ],
  questions: [
    {
      ask: "In how few throws can a cell of five letters be reached, at most?",
      answer: "In five, from anywhere in the triangle: its letters, from the last to the first.",
    },
    {
      ask: "The point is in the cell 213. Where is it after a throw towards 3?",
      answer: "In 3213, and so in 321: the throw puts its number in front.",
    },
    {
      ask: "When are fewer throws enough than a cell has letters?",
      answer:
        "When the point already lies where the end of the address says: from the cell 13, one throw towards 2 leads into 213.",
    },
    {
      ask: "How do you give the same target to a whole class?",
      answer:
        "Choose it, and press the link symbol at the top of the page. The copied link holds the target, in letters that do not show the answer, and none of your throws.",
    },
  ],
  answer:
    "2, then 3, then 1: the last throw chooses the large piece, so the address is thrown from its last letter to its first.",
  solutions: [
    "1, 2, 1, 3: the address of the cell is 3121.",
    "2312: the point is in piece 2, and enlarged in piece 3, then in piece 1, then in piece 2.",
  ],
  onPaper: [
    {
      ask: "Which four throws bring a point from anywhere in the triangle into the framed cell? Which comes first, and why?",
      space: "picture",
      answer: "1, 2, 1, 3. The address of the cell is 3121, and the last throw is its first letter.",
    },
    {
      ask: "In which cell of four letters does point 0 lie? Find the large piece that it is in, then the piece of that piece, and so on.",
      space: "picture",
      answer: "2312.",
    },
  ],
};
