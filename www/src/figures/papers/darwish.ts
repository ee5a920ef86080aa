import type { Section } from "./section";

/** Darwish & Abd-El-Wahab, “IFS Fractal Animation”. */
export const DARWISH: readonly Section[] = [
  {
    number: "1",
    title: "Introduction",
    about: "A shape that is given by parameters is moved by its parameters, without any of its points.",
    also: ["s1", "e28"],
  },
  {
    number: "2",
    title: "Object Oriented System for an IFS Animation",
    about: "An object is its list of maps; the eye stays at the origin, and the objects are moved.",
    also: ["s3", "s7", "s8"],
    tools: ["space"],
  },
  {
    number: "3",
    title: "IFS Fractals under Linear Transforms",
    about: "What becomes of the maps when the shape is moved, turned or stretched.",
    also: ["s34", "e28"],
  },
  {
    number: "3.1",
    title: "Mathematical details",
    about: "What the next sections hold: they lead to their pages.",
    also: ["s34", "s35"],
  },
  {
    number: "3.2",
    title: "Basic definitions",
    about: "The shape of a list of maps, when a map contracts, and how far apart two shapes are.",
    holds: "Definitions 1, 2, 3 and 4, Hausdorff distance, contractivity",
    also: ["e12", "e14", "e23"],
  },
  {
    number: "3.3",
    title: "The Effect of Continuous Change in Parameters on Fractal Images",
    about: "Turn the numbers of the maps without a jump, and the shape follows without one.",
    also: ["e6", "5"],
    tools: ["morph"],
  },
  {
    number: "3.4",
    title: "Linear Transformations to IFS fractals",
    about:
      "One formula for every move: each map is conjugated. The triangle is turned by it again and again.",
    holds: "equations 1 and 2, Figures i, ii, iii, iv",
    pages: ["s34", "s1", "s2", "s3", "s4"],
    also: ["e28"],
    tools: ["space"],
  },
  {
    number: "3.5",
    title: "Projection of IFS Fractal",
    about: "A shape pressed flat, by a factor that is nearly nothing, and which numbers run away.",
    pages: ["s35"],
    also: ["e24"],
  },
  {
    number: "3.6",
    title: "General Procedures",
    about:
      "Find the matrix, take the maps to new ones by equation 1, draw them by the chaos game: three steps.",
    holds: "Steps 1, 2 and 3",
    also: ["s34", "s2", "e2", "e28"],
    tools: ["space"],
  },
  {
    number: "4",
    title: "Results and Conclusion",
    about: "A triangle, a pyramid and a landscape, turned; and whether what two fractals share is one again.",
    holds: "Figures i, ii, iii, iv, v, vi, vii, viii, open question, intersection",
    pages: ["s5", "s6", "s7", "s8", "s9", "s10"],
    also: ["s1", "s2", "s3", "s4"],
    tools: ["space"],
  },
];
