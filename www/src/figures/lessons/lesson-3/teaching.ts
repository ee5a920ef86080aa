import type { Teaching } from "../frame/teaching";

export const TEACHING: Teaching = {
  aim: "To draw the overlap graph of a shape, and to read from it whether the shape is in one piece.",
  mistakes: [
    "“Every dot has to have a line to every other.” It is enough that there is a way along the lines.",
    "“One has to look at the small pieces, too.” Each of them is made as the whole is: what the graph says holds in each.",
    "“If the boxes around two pieces meet, the pieces do.” Two squares may share an edge, and the dusts in them be apart.",
  ],
  questions: [
    {
      ask: "How many lines must a graph of five dots have, at least, if it is to hang together?",
      answer: "Four. With fewer some dot cannot be reached.",
    },
    {
      ask: "A shape has two pieces, and they do not touch. How many parts does it have?",
      answer: "Infinitely many: each piece is in two parts itself, and so on. It is a dust.",
    },
    {
      ask: "Draw the overlap graphs of the gasket and of Koch’s curve.",
      answer: "A triangle, and a chain of four dots.",
    },
  ],
  answer:
    "1 and 2, 3 and 4, no others: two groups, so the curve is in pieces. No line leads from the left half to the right one.",
  solutions: [
    "The middle cell and the four next to it, or the middle cell and the four corners.",
    "Two cells one above the other, for example: the shape is then a dust on a line, and its two pieces are apart though their cells share an edge.",
  ],
  onPaper: [
    {
      ask: "Each piece of a shape is the whole, a third as large, in one of the nine cells of a square. Choose five cells so that the overlap graph is a star: one dot has a line to each of the other four, and there are no more lines. Draw the cells and the graph.",
      space: "squares",
      answer: "The middle cell and the four next to it, or the middle cell and the four corners.",
    },
    {
      ask: "Two cells of the nine, one above the other, share an edge. The shape of just these two, a third as large each, is in pieces all the same. Draw the first two steps, and say why.",
      space: "squares",
      answer:
        "In each cell only two cells of nine are kept, one above the other: the shape is a dust on an upright line. Of the lower two cells, say, it reaches up to 1/2, its pieces from 0 to 1/6 and from 1/3 to 1/2.",
    },
  ],
};
