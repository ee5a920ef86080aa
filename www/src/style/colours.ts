/** Colours that documents and saved pictures name, whatever the theme. */

/** Told apart by everybody, and clear on light and on dark ground. */
export const FOUR = ["#0072b2", "#e69f00", "#009e73", "#cc79a7"] as const;

/** Where no palette says otherwise. */
export const GREY = "#808080";

export const WHITE = "#ffffff";
/** Of what a drawing says no colour of. */
export const BLACK = "#000000";
/** Of lines and numbers on white. */
export const INK = "#1d1e22";
export const BAD = "#b3321d";

/** The stage of the light page and of the dark one, as the tokens have them. Documents name them, so they stay. */
export const PAPER = "#fbfaf6";
export const NIGHT = "#0e1015";
