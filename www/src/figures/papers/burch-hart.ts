import type { Section } from "./section";

/** Burch & Hart 1997, “Linear Fractal Shape Interpolation”. */
export const BURCH_HART: readonly Section[] = [
  {
    number: "1",
    title: "Introduction",
    about: "A shape is the union of smaller copies of itself, and its maps are what is stored.",
    holds: "equation 1",
    also: ["e12", "e13"],
  },
  {
    number: "2",
    title: "Previous Work",
    about: "What was known of morphing pictures and shapes. It shows nothing that could be drawn here.",
  },
  {
    number: "2.1",
    title: "Polygon Morphing",
    about:
      "Polygons morphed by others. Frond morphs outlines as closed curves of copies instead: fit two, and use them as A and B.",
    tools: ["fit"],
  },
  {
    number: "2.2",
    title: "Linear Fractal Morphing",
    about:
      "A small change of the maps moves the shape a little; number by number it may collapse on the way.",
    holds: "Theorem 1",
    also: ["3", "e25"],
    tools: ["morph"],
  },
  {
    number: "3",
    title: "Interpolating Affine Transformations",
    about: "The polar decomposition takes a map apart into a turn and a stretch, and each is led on its own.",
    holds: "equations 2 and 3",
    also: ["3", "e6"],
  },
  {
    number: "4",
    title: "Connectedness",
    about: "In one piece, and joined by paths: what both words mean.",
    holds: "Definitions 1 and 2",
    also: ["e1", "e3"],
  },
  {
    number: "4.1",
    title: "An Object-Based Connectedness Algorithm",
    about: "Barnsley’s test, which proves a shape to be in pieces.",
    holds: "Figure 1, equation 4",
    pages: ["1"],
    also: ["e4"],
  },
  {
    number: "4.2",
    title: "Path Connected Attractors",
    about: "A shape is in one piece exactly when its overlap graph is.",
    holds: "Definition 3, Theorem 2",
    also: ["e3", "2"],
  },
  {
    number: "4.3",
    title: "An Image-Based Path Connectedness Algorithm",
    about: "The index buffer: pixels that two pieces hit give the overlap graph its edges.",
    holds: "Figure 2, Definition 4, Theorem 3",
    pages: ["2"],
    also: ["e5"],
  },
  {
    number: "5",
    title: "Interpolation of IFS Attractors",
    about: "Two parameters u and v, and the map of all in-betweens that are in one piece.",
    holds: "equations 5 and 6",
    also: ["7", "e20"],
    tools: ["morph"],
  },
  {
    number: "6",
    title: "Results",
    about: "Morphs straight on and led, and how well the index buffer tells.",
    also: ["3", "5", "6", "7", "table-1"],
  },
  {
    number: "6.1",
    title: "Morphing Effects",
    about: "The two ways to turn a map, and the straight and the led way from dragon to gasket.",
    holds: "Figures 3, 4, 5, 6 and 7",
    pages: ["3", "5", "6", "7"],
    also: ["e6", "e7"],
    tools: ["morph"],
  },
  {
    number: "6.2",
    title: "Fast Connectedness Algorithm Performance",
    about: "The index buffer at four resolutions, measured on gaskets that just fall apart.",
    holds: "Table 1",
    pages: ["table-1"],
    also: ["e5"],
  },
  {
    number: "7",
    title: "Conclusion",
    about:
      "A picture that looks connected is no proof that the shape is: what pixels tell, and what they hide.",
    also: ["table-1", "e5"],
  },
  {
    number: "7.1",
    title: "Future Work",
    about:
      "Which map becomes which, unequal numbers of maps, shapes of several states, and no path: Frond answers each.",
    pages: ["section-7"],
    also: ["e10"],
    tools: ["morph"],
  },
  { number: "7.2", title: "Acknowledgments", about: "Thanks of the authors: nothing to show." },
];
