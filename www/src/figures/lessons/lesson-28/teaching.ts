import type { Teaching } from "../frame/teaching";

export const TEACHING: Teaching = {
  aim: "To turn and move a shape by changing its maps, and to say which of their numbers change.",
  mistakes: [
    "“A turned shape needs maps that turn.” The maps say how the copies stand within the whole; that does not change.",
    "“To move a shape by 1, add 1 to each shift.” The copies are moved once more by the map itself: of maps that halve, add one half.",
    "“The order of T and its inverse does not matter.” The other order turns the shape the other way.",
  ],
  questions: [
    {
      ask: "A map shrinks to a third. The shape is to be moved by 1. What is added to its shift?",
      answer: "Two thirds: 1 − 1/3.",
    },
    {
      ask: "The shape is made twice as large about the origin. What changes in its maps?",
      answer: "The shifts are doubled; the matrices stay.",
    },
    {
      ask: "The fern’s large map turns a little. The fern is turned by a quarter in the plane. Does the matrix of that map change?",
      answer:
        "No: it only turns and shrinks alike in all directions, and turns of the plane change places with each other. Those of the leaves do change, since they shrink more in one direction.",
    },
  ],
  answer:
    "The shift alone: a matrix that only halves is the same before a turn and after it, so that the turns around it cancel.",
  solutions: [
    "120° or 240°: the three maps of the foot change places.",
    "0.3: the map halves what was moved back, so −0.3 + 0.6 are left.",
  ],
  onPaper: [
    {
      ask: "Three maps halve everything towards the corners (0, 0), (8, 0) and (4, 6): each is ½ x + ½ c. The shape is turned by a quarter to the left about (0, 0). Draw both triangles. Which shifts do the new maps have?",
      space: "squares",
      answer:
        "The corners become (0, 0), (0, 8) and (−6, 4), so the shifts are (0, 0), (0, 4) and (−3, 2). The ½ stays.",
    },
    "same",
  ],
};
