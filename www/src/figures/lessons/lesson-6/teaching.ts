import type { Teaching } from "../frame/teaching";

export const TEACHING: Teaching = {
  aim: "To say why blending the numbers of two maps makes a turning piece smaller, and what to blend instead.",
  mistakes: [
    "“The mean of two maps is the map half-way.” It is a map, but a smaller one if the two are turned against each other.",
    "“Shrinking on the way is a fault of the drawing.” The blended map itself has a smaller determinant.",
    "“By turning there is only one way.” A half turn may go round either way, and something has to choose.",
  ],
  questions: [
    {
      ask: "A piece turns by a quarter, number by number. How large is it half-way?",
      answer: "√½, about 0.707 times as tall and as wide, so half of its area is left.",
    },
    {
      ask: "More and more stops are put on the way, at even angles. What does the way become?",
      answer: "The turn itself: with very many stops the letter hardly shrinks between two.",
    },
    {
      ask: "Which two letters can be blended number by number without any harm?",
      answer:
        "Those that are not turned against each other, such as a small and a large one that both stand upright.",
    },
  ],
  answer:
    "A single point. A half turn changes the sign of every number, so their means are 0, and the map sends everything to one place.",
  solutions: [
    "120°. Half-way lies the middle of the chord between two points of a circle; it is cos(120° / 2) = ½ of the radius away from the centre.",
    "A stop at 90°. Then each part is a quarter turn, and the least on the way is cos 45° = 0.707.",
  ],
  onPaper: [
    {
      ask: "A letter is turned by some angle and led back number by number. Half-way each of its points is in the middle of a straight line, from where it was to where it shall be. For which angle is the letter half as large there? Draw the circle on which a point lies, and the line.",
      space: "squares",
      answer:
        "120°: half-way is the middle of the chord, and it is cos(120° / 2) = ½ of the radius away from the centre.",
    },
    {
      ask: "A half turn is made in three equal parts, number by number in each. How large is the letter at least on the way, as a part of what it was? And with two equal parts? (cos 30° = 0.866, cos 45° = 0.707)",
      answer: "Each part is a turn of 60°: 0.866. With two parts of 90° it is 0.707.",
    },
  ],
};
