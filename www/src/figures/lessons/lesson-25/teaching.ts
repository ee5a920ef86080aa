import type { Teaching } from "../frame/teaching";

export const TEACHING: Teaching = {
  aim: "To see that the edge between one piece and dust is no smooth line, and to tell what is proved from what is only likely.",
  mistakes: [
    "“Larger pieces hold together better.” Larger in size they do, in the end; but at the same size it is the angle that decides.",
    "“Between two shapes in one piece all are in one piece.” The walk shows dust between them.",
    "“Not proved means dust.” It means that the program could not tell: the true answer may be either.",
  ],
  questions: [
    {
      ask: "Why is it enough to walk from 0° to 90°?",
      answer:
        "M is the same for s, for −s and for s mirrored at the real line: the other quarters show nothing new.",
    },
    {
      ask: "Which shapes lie on the circle of size ½?",
      answer: "Dust, but for the two at 0° and 180°: these are line segments.",
    },
    {
      ask: "May two neighbouring degrees, both in one piece, have dust between them?",
      answer: "Yes. Nothing was looked at between them, and M has narrow bays.",
    },
  ],
  answer:
    "Three times, degree by degree: in one piece to 68°, dust from 69° to 75°, in one piece from 76° to 81°, and dust from 82° on.",
  solutions: ["81°.", "0.708: its square, 0.5013, is just above ½, and that of 0.707 is 0.4998."],
  onPaper: [
    {
      ask: "On the circle of size 0.68 it is proved: 66° to 68° in one piece, 69° to 75° dust, 76° to 81° in one piece, 82° to 90° dust. How often is the edge of M crossed between 66° and 90°, at least? May it be more often?",
      answer: "Three times. It may be more often: nobody has looked between two degrees.",
    },
    {
      ask: "Let s point straight up: s = ri. Then s² = −r², and the shape is made of two dusts of scale r², which close at ½. From which r on is it in one piece? Give it to three digits.",
      answer: "From the root of ½, 0.7071, on: 0.708 is the first thousandth.",
    },
  ],
};
