/** The lessons, in the order in which they build on each other. */
import type { Entry } from "../list";
import { Lesson1 } from "./lesson-1/page";
import { Lesson2 } from "./lesson-2/page";
import { Lesson3 } from "./lesson-3/page";
import { Lesson4 } from "./lesson-4/page";
import { Lesson5 } from "./lesson-5/page";
import { Lesson6 } from "./lesson-6/page";
import { Lesson7 } from "./lesson-7/page";
import { Lesson8 } from "./lesson-8/page";
import { Lesson9 } from "./lesson-9/page";
import { Lesson10 } from "./lesson-10/page";
import { Lesson11 } from "./lesson-11/page";
import * as thumbs from "./thumbs";

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
  {
    id: "e3",
    number: "Lesson 3",
    short: "3",
    title: "Dots and lines: the overlap graph",
    about: "A dot for each piece, a line where two touch: that is all it takes.",
    Page: Lesson3,
    Thumb: thumbs.Net,
  },
  {
    id: "e4",
    number: "Lesson 4",
    short: "4",
    title: "A bound that closes in",
    about: "How a machine proves pieces apart, and why it cannot prove them together.",
    Page: Lesson4,
    Thumb: thumbs.Bars,
  },
  {
    id: "e5",
    number: "Lesson 5",
    short: "5",
    title: "What pixels hide",
    about: "The same shape, connected or not: it depends on the picture.",
    Page: Lesson5,
    Thumb: thumbs.Coarse,
  },
  {
    id: "e6",
    number: "Lesson 6",
    short: "6",
    title: "Half-way round: why polar",
    about: "Blend six numbers, and a turning piece vanishes on the way.",
    Page: Lesson6,
    Thumb: thumbs.Letters,
  },
  {
    id: "e7",
    number: "Lesson 7",
    short: "7",
    title: "Straight on, or led",
    about: "Find where a morph breaks, then lead it round.",
    Page: Lesson7,
    Thumb: thumbs.Led,
  },
  {
    id: "e8",
    number: "Lesson 8",
    short: "8",
    title: "One number, one shape: the set M",
    about: "All shapes of two equal pieces on one map: one piece, or dust.",
    Page: Lesson8,
    Thumb: thumbs.Tame,
  },
  {
    id: "e9",
    number: "Lesson 9",
    short: "9",
    title: "Why three differs from two",
    about: "Two pieces meet and the third stands alone: what is the gap?",
    Page: Lesson9,
    Thumb: thumbs.Alone,
  },
  {
    id: "e10",
    number: "Lesson 10",
    short: "10",
    title: "The wrong pairing",
    about: "Which piece becomes which decides whether a morph can hold together.",
    Page: Lesson10,
    Thumb: thumbs.Paired,
  },
  {
    id: "e11",
    number: "Lesson 11",
    short: "11",
    title: "Plain or fractal?",
    about: "Lift one point of a shape: what do the far corners do?",
    Page: Lesson11,
    Thumb: thumbs.Far,
  },
];
