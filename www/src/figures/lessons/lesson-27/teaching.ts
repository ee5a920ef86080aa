import type { Teaching } from "../frame/teaching";

export const TEACHING: Teaching = {
  aim: "To see a shape as the few numbers of its maps, and to say how much an error in them can do at most.",
  mistakes: [
    "“Small errors pile up without end.” They are made smaller with every copy of a copy: their sum is bounded.",
    "“Any picture is a few maps.” Only one that is made of copies of itself, or nearly so.",
    "“The promise says how far it is.” It says how far at most; mostly it is less.",
  ],
  questions: [
    {
      ask: "How many numbers are the fern of four maps, with the chances of its dice?",
      answer: "Four times six, and four chances: 28; the last chance follows from the others.",
    },
    {
      ask: "One map shrinks to 0.9, the others to 0.5. What does that do to the promise?",
      answer: "It is ten times the error of a single map: 1 / (1 − 0.9).",
    },
    {
      ask: "Would the leaf be the same in kilometres, with the same digits?",
      answer:
        "No: the shifts would be small numbers then, and lose more by rounding. Digits after the point are a length.",
    },
  ],
  answer: "3: with three digits the leaf is surely within 0.0017 of its height, with two only within 0.036.",
  solutions: ["36 bytes: the picture is 312 times as long.", "0.70: 0.003 / 0.3 is 0.01."],
  onPaper: ["same", "same"],
};
