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
  onPaper: [
    {
      ask: "Let s = 0.7i. Work out s², s³ and s⁴. Which powers of s are real numbers, and which have no real part? Why is the shape made of two dusts, one across and one up?",
      answer:
        "−0.49, −0.343i and 0.2401: the even powers are real, the odd ones are not. A point of the shape is a sum of powers with signs: its real part lies in a dust of scale 0.49, and so does its imaginary part, made smaller by 0.7.",
    },
    {
      ask: "With |s| below ½ all is dust. Take s = ½: one map is z/2 − 1, the other z/2 + 1. Which points do they leave in place? What is the shape, and where are its two pieces?",
      space: "squares",
      answer:
        "−2 and 2. It is the segment from −2 to 2, and its pieces are the two halves, from −2 to 0 and from 0 to 2.",
    },
  ],
};
