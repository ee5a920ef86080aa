/** The figures and tables of Cochran, Hart & Flynn, in their order. */
import { Fit1 } from "./c1";
import { Fit2 } from "./c2";
import { Fit3 } from "./c3";
import { Fit4 } from "./c4";
import type { Entry } from "./catalogue";
import * as thumbs from "./fit-thumbs";

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
];
