/** The ten lessons, in the order in which they build on each other. */
import type { Entry } from "./catalogue";
import { Lesson1 } from "./e1";
import { Lesson2 } from "./e2";
import * as thumbs from "./lesson-thumbs";

export const LESSONS: readonly Entry[] = [
  {
    id: "e1",
    number: "Lesson 1",
    short: "1",
    title: "Two pieces that touch",
    about: "What touching means, and how little it takes to part.",
    Page: Lesson1,
    Thumb: thumbs.Meeting,
  },
  {
    id: "e2",
    number: "Lesson 2",
    short: "2",
    title: "The chaos game, thrown by hand",
    about: "Half of the way to a corner, at random: what never gets a mark?",
    Page: Lesson2,
    Thumb: thumbs.Game,
  },
];
