import type { Teaching } from "../frame/teaching";

export const TEACHING: Teaching = {
  aim: "To see the shadow of a shape of space as a shape of the plane with maps of its own, and to say when that is so.",
  mistakes: [
    "That what is full of holes has a shadow full of holes. Holes at different depths need not lie behind each other.",
    "That every shadow is made of copies of itself. It is when all maps keep the direction of the light; maps that turn it need not leave it so.",
    "That the shadow of a shape has the dimension of the shape. It cannot have more than that, nor more than the 2 of the plane.",
  ],
  questions: [
    {
      ask: "The sponge is made of 20 copies. Seen from the front, how many different places do they take?",
      answer:
        "8: the small squares round the middle one. Each of the four corners hides three cubes, each of the four edges two.",
    },
    {
      ask: "And seen along a diagonal of the cube?",
      answer:
        "19. The 27 small cubes take 19 places, and in each of them there is at least one of the 20 that stay: so nothing is missing.",
    },
    {
      ask: "What is the shadow of the lying tetrahedron, lit from above, after the first step only: four solid half-size tetrahedra?",
      answer:
        "Already the whole square: each of them has a square of half the side for its shadow, one in each corner.",
    },
  ],
  answer:
    "A square without a hole: the four copies of a copy fill the four quarters of its square, and so on down.",
  solutions: [
    "45° round, and 35° up: there the shadow is a whole hexagon.",
    "60° round and 35° up, for example: the light then comes at right angles to two edges that do not meet.",
  ],
  onPaper: [
    {
      ask: "A cube is cut into 27 small ones, and the middle one of each face and the one in the middle of all are taken away. Draw the shadow from straight in front, after this step and after the same step with each small cube.",
      space: "squares",
      answer:
        "A square of nine without the one in the middle; then each of the eight without its own middle.",
    },
    {
      ask: "A tetrahedron balances on an edge. From above it is a square, whose diagonals are the lowest and the highest edge. Four half-size copies stand in its corners. Where do their shadows fall? Draw this step and the next one. What of the square is missing?",
      space: "squares",
      answer:
        "Each falls into one quarter of the square, and the four quarters are all of it: nothing is missing, at any step.",
    },
  ],
};
