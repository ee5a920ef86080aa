import type { Section } from "./section";

/** Fujimoto, Ohno, Muraoka & Chiba, “Fractal Deformation Using Displacement Vectors …”. */
export const FUJIMOTO: readonly Section[] = [
  {
    number: "1",
    title: "Introduction",
    about: "A bend that is repeated in every part of the shape, beside one that bends only the whole.",
    also: ["d4", "e11"],
    tools: ["deform"],
  },
  {
    number: "2",
    title: "Related Work",
    about: "Shapes deformed by changing their maps, Burch and Hart’s morphs among them: those are here, too.",
    also: ["3", "6"],
    tools: ["morph"],
  },
  {
    number: "3",
    title: "Extended Unit Iterated Shuffle Transformation",
    about: "On codes alone: the letters between two places change their order, and twice is as before.",
    holds: "Definitions 1 and 2, Theorems 1, 2 and 3, equations 1, 2, 3, 4, 5 and 6",
    also: ["d3", "d1", "e22"],
  },
  {
    number: "4",
    title: "Local Resemblance in Space/Scale Directions",
    about: "Parts that are near each other, and parts that lie alike at another scale, answer alike.",
    also: ["d3", "d6", "e22"],
  },
  {
    number: "5",
    title: "Fractal Deformation",
    about: "What follows, on shapes of the plane.",
    also: ["d4", "d5", "d6", "e11"],
    tools: ["deform"],
  },
  {
    number: "5.1",
    title: "Addressing Points on Geometric Shape",
    about: "A code for every point of a line, a square, a gasket.",
    holds: "Figures 1 and 2, equations 7, 8 and 9",
    pages: ["d1", "d2"],
    also: ["e16"],
  },
  {
    number: "5.2",
    title: "Ext-unit-IST on Geometric Shape",
    about: "The shuffle of codes, seen by the colours that it carries along.",
    holds: "Figure 3, equations 10, 11, 12 and 13",
    pages: ["d3"],
  },
  {
    number: "5.3",
    title: "Fractal Deformation Based on Ext-unit-IST",
    about:
      "Displacements are shuffled: a gasket, a fern and a twin-dragon are bent, and a sponge of space here.",
    holds: "Figures 4, 5 and 6, equations 14, 15, 16, 17 and 18",
    pages: ["d4", "d5", "d6", "d53"],
    also: ["e11", "e22"],
    tools: ["deform"],
  },
  {
    number: "5.4",
    title: "Continuous Transition between Continuous and Fractal Deformations",
    about: "From plain to fractal without a jump: a slider below Figure 4, and in Deform.",
    holds: "equation 19",
    also: ["d4", "e22"],
    tools: ["deform"],
  },
  {
    number: "6",
    title: "Conclusion and Future Work",
    about:
      "Other dimensions, shuffles that tear nothing, and real pictures: a sponge is bent in space, the leaf of a photograph in Fit (“Deform its photo”).",
    also: ["d53"],
    tools: ["deform", "space"],
  },
];
