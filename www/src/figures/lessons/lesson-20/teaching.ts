import type { Teaching } from "../frame/teaching";

export const TEACHING: Teaching = {
  aim: "To read a map of shapes: to say what a point of it stands for, what each of its colours claims, and what it leaves open.",
  mistakes: [
    "That the map is a picture of a shape. Each of its points is a whole shape; the map only says what is known of it.",
    "That a place beside a whole shape is whole. The gasket itself lies on the border: a small step to one side opens a gap.",
    "That “looks whole” means whole. It says that no gap was found that this resolution would show.",
  ],
  questions: [
    {
      ask: "What are u and v of shape A, of shape B, and of the middle of the straight way between them?",
      answer: "(0, 0), (1, 1) and (0.5, 0.5).",
    },
    {
      ask: "Half-way between a whole and a broken shape the shape is broken. On which side is there a border for certain?",
      answer:
        "Between the whole one and the middle. On the other side there may be borders as well, but need not be.",
    },
    {
      ask: "The map has 8281 samples. What does it say of the points between them?",
      answer:
        "Nothing by itself. A gap changes without jumps, so that a wide one reaches to the points nearby; a thin line may slip between samples.",
    },
  ],
  answer:
    "Place 3, the one that is far from both A and B. Its pieces lie across each other, and a small push does not part what crosses.",
  solutions: [
    "u = 0.45, v = 0.5, for example.",
    "Near u = 0.4465 on the line v = 0.5: 0.446 is in one piece and 0.447 is not.",
  ],
  onPaper: [
    {
      ask: "Draw the map of shapes from (0, 0) to (1, 1), u across and v up. Mark A, B, the middle of the straight way, and the shape that has turned half of the way and has not moved at all. What are its numbers?",
      space: "squares",
      answer: "A = (0, 0), B = (1, 1), the middle (0.5, 0.5), and (0.5, 0).",
    },
    {
      ask: "On a line of the map the shape at u = 0 is in one piece and that at u = 0.5 in pieces. You may ask about one shape at a time, always in the middle. The answers: 0.25 in pieces, 0.125 in one piece, 0.1875 in pieces, 0.15625 in one piece. Between which two numbers is a border? How many questions in all until they are within 0.002?",
      answer:
        "Between 0.15625 and 0.1875. Eight: each question halves what is left, and 0.5 / 256 is 0.00195.",
    },
  ],
};
