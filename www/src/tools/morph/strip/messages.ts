/** What the timeline says. */

export const inPieces = "in pieces";
export const noAttractor = "no attractor";
export const notDecided = "not decided";
export const filmMorph = "Film of the morph";
export const pictureLoading = "picture loading";
export const atMoment = (words: string) => `At ${words}`;

export const time = "Time";
export const offPath = (percent: string) => `${percent}; the picture is off the path`;
export const searchingPath = (percent: string) => `${percent}; Frond is searching for a path`;
export const pictureOffPath = "picture off the path";
export const worstAt = (gap: string, percent: string) => `Widest gap: ${gap}, at ${percent}`;
export const timeInPercent = "Time in percent";
export const loopBackAndForth = "Loop back and forth";
export const speed = "Speed";
