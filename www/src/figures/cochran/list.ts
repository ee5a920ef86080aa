/** The figures and tables of Cochran, Hart & Flynn, in their order. */

import type { Entry } from "../list";
import { Fit1 } from "./figure-1/page";
import { Fit2 } from "./figure-2/page";
import { Fit3 } from "./figure-3/page";
import { Fit4 } from "./figure-4/page";
import { Fit5 } from "./figure-5/page";
import { Fit6 } from "./figure-6/page";
import { Fit7 } from "./figure-7/page";
import { FitTable2 } from "./table-2/page";
import * as thumbs from "./thumbs";

export const FITS: readonly Entry[] = [
  {
    id: "c1",
    number: "Rough curves, Figure 1",
    short: "1",
    title: "Through three points, as rough as you like",
    about: "Drag the points and turn the roughness: a curve made of two copies of itself.",
    Page: Fit1,
    Thumb: thumbs.Interpolated,
  },
  {
    id: "c2",
    also: ["ct1"],
    number: "Rough curves, Figure 2 and Table 1",
    short: "2, T1",
    title: "A mountain range of ten numbers",
    about: "Two maps, and a step between them that no print shows.",
    Page: Fit2,
    Thumb: thumbs.TwoMaps,
  },
  {
    id: "ct2",
    number: "Rough curves, Table 2",
    short: "T2",
    title: "Points that vote for their maps",
    about: "Millions of votes heap up over the two maps, and over their echoes.",
    Page: FitTable2,
    Thumb: thumbs.Votes,
  },
  {
    id: "c3",
    number: "Rough curves, Figure 3",
    short: "3",
    title: "One curve in space, three shadows",
    about: "Turn a curve through a gasket, and see what its shadows hide.",
    Page: Fit3,
    Thumb: thumbs.InSpace,
  },
  {
    id: "c4",
    number: "Rough curves, Figure 4",
    short: "4",
    title: "Rough, and no copy of itself",
    about: "The view from above: its middle third is the whole, its sides are not.",
    Page: Fit4,
    Thumb: thumbs.Top,
  },
  {
    id: "c5",
    number: "Rough curves, Figure 5",
    short: "5",
    title: "Heaps of votes, seen from four sides",
    about: "A hundred clusters in a space of five dimensions that is nearly flat.",
    Page: Fit5,
    Thumb: thumbs.Heaps,
  },
  {
    id: "c6",
    also: ["ct3"],
    number: "Rough curves, Figure 6 and Table 3",
    short: "6, T3",
    title: "Seven maps, or eleven",
    about: "Parts that copy parts, how far they are off, and an open question answered.",
    Page: Fit6,
    Thumb: thumbs.Overlaid,
  },
  {
    id: "c7",
    number: "Rough curves, Figure 7",
    short: "7",
    title: "A leaf in few numbers",
    about: "The paper’s fits with their gaps, and a closed curve of as many numbers.",
    Page: Fit7,
    Thumb: thumbs.Leaf,
  },
];
