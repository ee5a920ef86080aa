import type { Teaching } from "../frame/teaching";

export const TEACHING: Teaching = {
  aim: "To say what a picture can tell about touching and what it cannot, and why more pixels do not settle it.",
  mistakes: [
    "“If I zoom in far enough I shall see whether they touch.” One sees a gap that is wide enough, but never that there is none.",
    "“A picture errs only by joining what is apart.” It may part what touches, too: a line between two pixels may run through the only common point.",
    "“More pixels are always better.” For a given shape a few more may be worse: it depends on where the lines of the grid fall.",
  ],
  questions: [
    {
      ask: "Two pieces are a thousandth of the side apart. How many pixels a side does one need to be sure to see the gap?",
      answer:
        "Two points of one pixel are at most 1.42 of its sides apart. So a pixel that is narrower than 0.7 of the gap cannot hold both: 1500 pixels to a side are enough.",
    },
    {
      ask: "Why does the picture of a shape whose pieces touch in one point depend on where the grid lies?",
      answer: "The point lies in one pixel or on a line between pixels. Only a pixel can be shared.",
    },
    {
      ask: "How can a computer know for sure that two pieces are apart, without pixels?",
      answer: "Put each piece, or each part of it, into a disc. If no two discs meet, the pieces are apart.",
    },
  ],
  answer:
    "From 0.4966 on: a gap that is much narrower than a pixel falls inside one, and is gone. Twice the pixels halve the lie, and never end it.",
  solutions: [
    "Any even number, 16 for example: the common point of pieces 1 and 2 then lies on a line between two pixels, and no pixel holds both tips.",
    "27: with 29 pixels it is wrong again.",
  ],
  onPaper: [
    {
      ask: "Pieces 1 and 2 of the gasket touch in one point, in the middle of the lower side. One picture has 15 pixels along that side, another one 16. In which of them can the two pieces share a pixel there, and why?",
      space: "squares",
      answer:
        "With 15 the middle lies within the eighth pixel, and both tips reach into it. With 16 it lies on the line between two pixels: the tip of one piece is on the left of it, that of the other on the right.",
    },
    {
      ask: "Two pieces are 0.04 of the side apart. How many pixels must the side have, so that no pixel can hold marks of both, however the grid lies? Two points of one pixel are at most 1.42 of its sides apart.",
      answer: "A pixel must be narrower than 0.04 / 1.42 = 0.0282 of the side: 36 are enough.",
    },
  ],
};
