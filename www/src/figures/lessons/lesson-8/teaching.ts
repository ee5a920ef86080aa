import type { Teaching } from "../frame/teaching";

export const TEACHING: Teaching = {
  aim: "To read one number as one shape, and the set M as the map of all those that are in one piece.",
  mistakes: [
    "“With two pieces a shape may be in three or four parts.” It is in one piece or it is dust: there is nothing between.",
    "“M is the Mandelbrot set.” It is another set, of other maps, which Barnsley and Harrington introduced in 1985.",
    "“The larger s, the rather in one piece, at every angle alike.” Between |s| = 1/2 and 0.7071 it depends on the angle.",
  ],
  questions: [
    {
      ask: "Why is all dust for |s| below 1/2?",
      answer: "Two pieces, each less than half as wide as the whole, cannot reach from end to end.",
    },
    { ask: "Which angle of s means that the pieces are not turned?", answer: "0: s is a positive number." },
    {
      ask: "The shapes of s and of its mirror image (with −y for y): how are they related?",
      answer: "They are mirror images of each other.",
    },
  ],
  answer:
    "It depends on the s that was chosen. Below |s| = ½ all is dust, from 0.7071 on all is in one piece; between the two circles only the shape itself tells.",
  solutions: [
    "0.7i: its square is −0.49, a real number, so the shape is made of two dusts of scale 0.49, one across and one up.",
    "½ or −½: the shape is a line segment. With |s| = ½ two pieces have together just the dimension of a line.",
  ],
};
