/** The figures of the paper on fractal deformation, in its order. */
import type { Entry } from "../list";
import { Deformation1 } from "./figure-1/page";
import { Deformation2 } from "./figure-2/page";
import { Deformation3 } from "./figure-3/page";
import { Deformation4 } from "./figure-4/page";
import { Deformation5 } from "./figure-5/page";
import { Deformation6 } from "./figure-6/page";
import * as thumbs from "./thumbs";

export const DEFORMS: readonly Entry[] = [
  {
    id: "d1",
    number: "Deformation, Figure 1",
    short: "1",
    title: "Every point has a code",
    about: "Letter by letter into a line and a square, by halves and by thirds.",
    Page: Deformation1,
    Thumb: thumbs.Codes,
  },
  {
    id: "d2",
    number: "Deformation, Figure 2",
    short: "2",
    title: "Codes on a gasket",
    about: "The letters are its maps, and where pieces overlap a place has several codes.",
    Page: Deformation2,
    Thumb: thumbs.Addresses,
  },
  {
    id: "d3",
    number: "Deformation, Figure 3",
    short: "3",
    title: "A picture, shuffled",
    about: "Letters in reverse order: what detail and locality do to colours.",
    Page: Deformation3,
    Thumb: thumbs.Colours,
  },
  {
    id: "d4",
    number: "Deformation, Figure 4",
    short: "4",
    title: "One pull, and every triangle answers",
    about: "The gasket bent in eight ways, and the slide from plain to fractal.",
    Page: Deformation4,
    Thumb: thumbs.Lifted,
  },
  {
    id: "d5",
    number: "Deformation, Figure 5",
    short: "5",
    title: "A fern in the wind",
    about: "Every leaf sways about its own stem.",
    Page: Deformation5,
    Thumb: thumbs.Swaying,
  },
  {
    id: "d6",
    number: "Deformation, Figure 6",
    short: "6",
    title: "A dragon that winds in its tips",
    about: "Drawn at one corner, with colours that tell which parts answer alike.",
    Page: Deformation6,
    Thumb: thumbs.Drawn,
  },
];
