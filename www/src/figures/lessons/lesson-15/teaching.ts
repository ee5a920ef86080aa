import type { Teaching } from "../frame/teaching";

export const TEACHING: Teaching = {
  aim: "To tell a shape from its shade: the maps settle the one, the chances of the die the other.",
  mistakes: [
    "“A piece with a small chance is a small piece.” Its size comes from its map; it only gets fewer marks.",
    "“With a chance of nearly 0 the piece is gone.” It gets marks as long as the chance is not 0, only late.",
    "“A fair die draws every shape evenly.” It does so where all pieces have the same size, as in the gasket.",
  ],
  questions: [
    {
      ask: "Piece 1 has chance 1/2, piece 2 has 1/3. How often does a throw land in piece 2 of piece 1?",
      answer: "In one throw of six: 1/2 · 1/3.",
    },
    {
      ask: "What is left of the gasket if the chance of piece 3 is exactly 0?",
      answer: "A line: maps 1 and 2 alone have the lower side as their shape.",
    },
    {
      ask: "A fern takes a minute with a fair die. Why not simply wait longer instead of choosing the die?",
      answer: "Each further pair of leaflets takes four times as long as the one below it.",
    },
  ],
  answer:
    "The lower leaflets in full, and hardly anything of the tip: map 2, which makes most of the fern, is thrown only one time in four, and the tip is map 2 again and again.",
  solutions: [
    "Weights 0.4, 0.6 and 1, or 0.6, 0.4 and 1: the chances are 0.2, 0.3 and 0.5, and 0.2 · 0.3 = 0.06.",
    "0.36, which is 0.6 · 0.6: a piece gets the share of the marks that it has of the area.",
  ],
  onPaper: [
    {
      ask: "Half of all throws shall land in piece 3, and 6 of 100 in piece 1 of piece 2. Both are framed. Which chances must the three faces of the die have?",
      space: "picture",
      answer: "0.2, 0.3 and 0.5, or 0.3, 0.2 and 0.5: then 0.2 · 0.3 = 0.06.",
    },
    "same",
  ],
};
