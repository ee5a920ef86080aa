import type { Teaching } from "../frame/teaching";

export const TEACHING: Teaching = {
  aim: "To read a shape off its maps: which map makes which part, and why each part has the same parts again.",
  mistakes: [
    "“The stem map draws the lowest bit of the stem only.” It draws that bit in the whole, and so in every leaf.",
    "“Four maps make a fern of four pieces, so it has little detail.” The pieces hold pieces without end.",
    "“A map may not be flat.” The stem's map presses the whole fern into a line: that is allowed.",
  ],
  questions: [
    {
      ask: "How many numbers does one map of the plane have, and how many the fern?",
      answer: "Six, and four times six: 24. Many of them are 0.",
    },
    {
      ask: "The large map has scale 0.85. How tall is the fifth pair of leaves, if the first is 10 cm?",
      answer: "10 · 0.85 to the power of 4, about 5.2 cm.",
    },
    {
      ask: "What would you change so that the leaves grow opposite each other?",
      answer: "Where the last two maps put their leaf: the same height for both.",
    },
  ],
  answer: "Every stem, down to the smallest: each leaf is a copy of the whole, and so is each leaflet.",
  solutions: [
    "Map 4: the leaves of one side are missing, and so are the leaflets of one side of each leaf.",
    "0°: the large map then no longer turns, and nothing bends.",
  ],
  onPaper: [
    {
      ask: "One map of this fern has been left out: 2, all but the lowest pair of leaves; 3, a leaf on the left; or 4, a leaf on the right. Which? How do you see it in a single leaf?",
      space: "picture",
      answer: "Map 4: the leaves of one side are missing, and so are the leaflets of one side of each leaf.",
    },
    {
      ask: "The large map of a fern makes everything 0.85 times as large. The lowest leaf is 20 cm long. How long are those above it on the same side? Which is the first one that is shorter than 10 cm?",
      answer: "17, 14.5, 12.3, 10.4 and 8.9 cm: the sixth.",
    },
  ],
};
