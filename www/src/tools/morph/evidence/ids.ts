/** The panel of evidence in the document, and what opens it: that has the focus again when it closes. */
export const PANEL_ID = "evidence";
export const CHIP_ID = "verdict-chip";
