/** Palettes that eyes with two kinds of cones tell apart as well: `safe-palettes.test.ts` asks by simulation. */

export interface SafePalette {
  id: string;
  name: string;
  /** Whose it is, and where it was published. */
  source: string;
  href: string;
  /** "#rrggbb", in the order of the source. */
  colours: readonly string[];
}

export const SAFE: readonly SafePalette[] = [
  {
    id: "okabe-ito",
    name: "Okabe and Ito",
    source: "M. Okabe and K. Ito, Color Universal Design, 2002, revised 2008",
    href: "https://jfly.uni-koeln.de/color/",
    // Without their black, which is lost on a dark ground.
    colours: ["#e69f00", "#56b4e9", "#009e73", "#f0e442", "#0072b2", "#d55e00", "#cc79a7"],
  },
  {
    id: "tol-vibrant",
    name: "Tol, vibrant",
    source: "P. Tol, Colour Schemes, technical note SRON/EPS/TN/09-002, 2021",
    href: "https://sronpersonalpages.nl/~pault/",
    colours: ["#ee7733", "#0077bb", "#33bbee", "#ee3377", "#cc3311", "#009988", "#bbbbbb"],
  },
  {
    id: "petroff",
    name: "Petroff",
    source: "M. A. Petroff, Accessible Color Sequences for Data Visualization, arXiv:2107.02270, 2021",
    href: "https://arxiv.org/abs/2107.02270",
    colours: [
      "#3f90da",
      "#ffa90e",
      "#bd1f01",
      "#94a4a2",
      "#832db6",
      "#a96b59",
      "#e76300",
      "#b9ac70",
      "#717581",
      "#92dadd",
    ],
  },
];
