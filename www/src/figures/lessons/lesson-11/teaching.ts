import type { Teaching } from "../frame/teaching";

export const TEACHING: Teaching = {
  aim: "To tell a bend of the whole from one that every part repeats, and to see how addresses make the second.",
  mistakes: [
    "“A fractal bend is a bend with noise.” Nothing in it is random: each part answers to the one pull.",
    "“The far corner answers because it is near the pull in some way.” It answers because its address, read backwards, leads there.",
    "“Reading backwards tears the shape.” Where parts meet, they are given one pull for both.",
  ],
  questions: [
    {
      ask: "Read backwards, where does the address 1123 lead?",
      answer: "To 3211: piece 3 of the whole, piece 2 of that, and so on.",
    },
    {
      ask: "What does locality 9 do with the far corner?",
      answer: "Hardly anything: it is the plain bend, and the corner is far from the pull.",
    },
    {
      ask: "Which is changed by roughness: where parts move, or how much?",
      answer: "How much: it weighs the small parts against the large.",
    },
  ],
  answer:
    "Each triangle is lifted in the middle of its own long side, at every scale. A code that ends like that of the middle begins like it when it is read the other way round.",
  solutions: [
    "2311: the letters of 1132 in the other order.",
    "1231: the first letter stays, and 132 is turned round.",
  ],
  onPaper: ["same", "same"],
};
