import type { Teaching } from "../frame/teaching";

export const TEACHING: Teaching = {
  aim: "To tell apart which levels of a shape answer to a pull, and how loudly each of them does; and to know the plain bend as an extreme of both.",
  mistakes: [
    "That roughness 0 leaves the shape at rest. The shares sum to 1 at every roughness: the first level gets all.",
    "That locality makes a bend weaker. It says from how near the pull may come, and not how strong it is.",
    "That small triangles would move by themselves. They take a pull that is there already, from another place.",
  ],
  questions: [
    {
      ask: "A point has the code 2311. Which pulls does it take at locality 0, with at most four letters turned round?",
      answer: "Those of 2311, 2311 again (one letter), 3211, 1321 and 1132.",
    },
    {
      ask: "And at locality 1?",
      answer: "The first letter stays: those of 2311, 2311 again, 2131 and 2113. All are in piece 2.",
    },
    {
      ask: "At which roughness have all levels the same share?",
      answer: "At 1: each share is as large as the one before.",
    },
  ],
  answer:
    "The plain bend, exactly. The shares of the levels sum to 1 at every roughness, and at 0 the first level, which turns no letter round, has all of it.",
  solutions: ["A roughness of 0.25 at most, and 0.1 at least.", "Locality 3."],
  onPaper: [
    {
      ask: "The roughness is 0.5, and there are only four levels: their shares are as 1, 0.5, 0.25 and 0.125. Work them out as parts of 100 and draw the bars. What are they with roughness 0?",
      space: "squares",
      answer: "53, 27, 13 and 7 of 100; with roughness 0 the first level has all 100.",
    },
    {
      ask: "A point has the code 1323. Which codes does it take pulls from at locality 0, when the first two letters are turned round, or three, or all four? And at locality 2?",
      answer: "Its own, 3123, 2313 and 3231. At locality 2 the first two letters stay: its own, and 1332.",
    },
  ],
};
