/** The figures of Darwish & Abd-El-Wahab, in their order, and what their paper leaves open. */
import type { Entry } from "../list";
import { Space1 } from "./figure-i/page";
import { Space2 } from "./figure-ii/page";
import { Space3 } from "./figure-iii/page";
import { Space4 } from "./figure-iv/page";
import { Space5 } from "./figure-v/page";
import { Space6 } from "./figure-vi/page";
import { Space7 } from "./figure-vii/page";
import { Tree, TreeTurned } from "./figure-vii/thumb";
import { Space8 } from "./figure-viii/page";
import { Space9 } from "./open-question/page";
import { OpenQuestion } from "./open-question/thumb";
import { Space35 } from "./section-3-5/page";
import * as thumbs from "./thumbs";

export const SPACES: readonly Entry[] = [
  {
    id: "s1",
    number: "Space, Figure i",
    short: "i",
    title: "A triangle hung up in space",
    about: "Three maps, and two sets of parameters for one picture.",
    Page: Space1,
    Thumb: thumbs.Upright,
  },
  {
    id: "s2",
    number: "Space, Figure ii",
    short: "ii",
    title: "Turned by its parameters",
    about: "No point is turned: the three maps are, and the picture is the same.",
    Page: Space2,
    Thumb: thumbs.Turned,
  },
  {
    id: "s3",
    number: "Space, Figure iii",
    short: "iii",
    title: "Carried before the eye",
    about: "The eye stays at the origin, and translations say where a map stands.",
    Page: Space3,
    Thumb: thumbs.Again,
  },
  {
    id: "s4",
    number: "Space, Figure iv",
    short: "iv",
    title: "Turned ten thousand times",
    about: "Parameters of parameters of parameters: how far does rounding get?",
    Page: Space4,
    Thumb: thumbs.OnceMore,
  },
  {
    id: "s5",
    number: "Space, Figure v",
    short: "v",
    title: "A pyramid of five halves",
    about: "Fifteen units before the eye, or thirty, as its print says.",
    Page: Space5,
    Thumb: thumbs.Pyramid,
  },
  {
    id: "s6",
    number: "Space, Figure vi",
    short: "vi",
    title: "The pyramid, turned",
    about: "About itself, or about the eye, which loses sight of it.",
    Page: Space6,
    Thumb: thumbs.PyramidTurned,
  },
  {
    id: "s7",
    number: "Space, Figure vii",
    short: "vii",
    title: "A landscape of parameters",
    about: "Ground, trees and clouds, each a list of maps, seen from the origin.",
    Page: Space7,
    Thumb: Tree,
  },
  {
    id: "s8",
    number: "Space, Figure viii",
    short: "viii",
    title: "The world turns",
    about: "One transform on the parameters of every object, and the eye stays where it is.",
    Page: Space8,
    Thumb: TreeTurned,
  },
  {
    id: "s35",
    number: "Space, Section 3.5",
    short: "3.5",
    title: "A shadow that costs infinity",
    about: "Flatten a shape by ε, and watch which of its numbers run away.",
    Page: Space35,
    Thumb: thumbs.Flat,
  },
  {
    id: "s9",
    number: "Space, the open question",
    short: "?",
    title: "The open question",
    about: "Is what two fractals share a fractal again? Once it is, and once it is proved not to be.",
    Page: Space9,
    Thumb: OpenQuestion,
  },
];
