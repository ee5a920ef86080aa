import type { Teaching } from "../frame/teaching";

export const TEACHING: Teaching = {
  aim: "To tell a proof that pieces are apart from a picture in which they look apart, and to see what such a proof cannot do.",
  mistakes: [
    "“If the points that stand for the pieces are apart, the pieces are.” Each point stands for a part that reaches around it.",
    "“With enough steps it is proved that they meet.” The bound only ever shows that pieces are apart.",
    "“A finer step is always nearer to the truth.” Before the bound falls below the distance nothing at all is known.",
  ],
  questions: [
    {
      ask: "By what factor does the reach of a bar shrink from one step to the next?",
      answer: "By r, the scale of the maps.",
    },
    {
      ask: "Pieces 0.2 apart: is a proof found sooner or later than for pieces 0.02 apart?",
      answer: "Sooner: the bars need not be as short.",
    },
    {
      ask: "For r = 1/2 the pieces meet. What does the machine say after a thousand steps?",
      answer: "That nothing is known yet.",
    },
  ],
  answer:
    "n = 5. The bound 2rⁿ⁺¹ falls to about half with each step, and gets below the distance there. The narrower the gap, the longer it takes.",
  solutions: [
    "r = 0.48, for example.",
    "5: 2 · 0.48⁶ = 0.0245 is below 0.04, and 2 · 0.48⁵ = 0.0510 is not.",
  ],
  onPaper: [
    {
      ask: "For r = 0.4 the gap is 0.2, and the distance that is measured is never less. Work out the bound 2rⁿ⁺¹ for n = 0, 1, 2 and 3. From which n on are the pieces surely proved apart?",
      answer: "0.8, 0.32, 0.128 and 0.0512: from n = 2 on.",
    },
    "same",
  ],
};
