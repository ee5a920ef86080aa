/** What an embedded Frond says. */

export const picture = "The picture";
export const time = "Time";
export const openInFrond = "Open in Frond";

// Answers to the page around, for its developers.
export const versionOnly = "Frond understands messages of version 1: { frond: 1, type: … }.";
export const seekNeeds = "seek needs t, a number from 0 to 1.";
export const openNeeds = "open needs fragment, the part of a link after #.";
export const knownTypes = "The known types are hello, play, pause, seek and open.";
