import type { Teaching } from "../frame/teaching";

export const TEACHING: Teaching = {
  aim: "To see that the maps alone decide which shape comes out, and that the start is forgotten step by step.",
  mistakes: [
    "“The gasket is made by cutting holes into a triangle.” It can be, but a triangle is only one start of many.",
    "“After many steps the shape is there.” It never is: the steps come near to it, as near as one likes.",
    "“A picture with more detail needs more steps.” Only its size counts: each step halves what is left of it.",
  ],
  questions: [
    {
      ask: "What does one step do to a figure that has nothing in it at all?",
      answer:
        "Nothing: the empty figure stays empty. That is why the theorem speaks of figures with at least one point.",
    },
    {
      ask: "Two starts are 8 cm apart. How far apart are they at most after five steps that halve?",
      answer: "8 / 32 of a centimetre, a quarter.",
    },
    {
      ask: "Why must all three maps shrink? Would two be enough?",
      answer: "A copy that is not made smaller keeps all of the difference, and hands it on at every step.",
    },
  ],
  answer: "Hardly anything: each step halves all distances, so eight steps leave 1/256 of the difference.",
  solutions: [
    "10 steps: 2 to the power of 10 is 1024, the first power of 2 above 1000.",
    "The gasket. It is made of three half-size copies of itself already.",
  ],
  onPaper: [
    "same",
    {
      ask: "Draw a square whose side is 16 small squares. A step makes three copies of all there is, half as large: at the lower left, at the lower right, and on top in the middle. Draw what is there after one step, and after two. What will come of it?",
      space: "squares",
      answer:
        "Three squares of side 8, then nine of side 4. They come near to a gasket, as any other start would.",
    },
  ],
};
