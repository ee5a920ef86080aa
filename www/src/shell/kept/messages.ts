/** What the list of recent documents says. */

export const aboutRecent = (most: number) =>
  `The last ${most} documents you changed, and those you pinned. They stay in this browser. `;
export const photosAndOutlinesNot =
  "Photos and outlines are not kept here. Fit keeps those of the fits that you save.";
export const recent = "Recent";
export const nothingYetFrondSaves = "Nothing yet. Frond saves your changes automatically after a second.";
export const wasRemoved = (name: string) => `${name} was removed.`;
export const openDocumentStaysRemove = "The open document stays. Remove all others, including pinned ones?";
export const listEmpty = "The list is empty.";
export const removeAll = (count: number) => `Remove all ${count}`;
export const keepThem = "Keep them";
export const clearAll = "Clear all";
export const untitled = "Untitled";
export const thisVersionFrondCannot = "This version of Frond cannot read it";
export const rename = (name: string) => `Rename ${name}`;
export const keepPermanently = (name: string) => `Keep ${name} permanently`;
export const unpin = "Unpin";
export const pin = "Pin";
export const remove = (name: string) => `Remove ${name}`;

export const thisDocumentTooLarge =
  "This document is too large to save here. The last saved version is still available.";
export const spaceShape = "Shape in space";
export const fromTo = (a: string, b: string) => `${a} to ${b}`;

export const notSaved = (problem: string) => `Your work is not being saved. ${problem}`;
export const continueWith = (name: string) => `Continue with ${name}?`;
export const continueLabel = "Continue";
/** Stands in for the name of a document that has none. */
export const yourLastDocument = "your last document";
export const pinnedAside = " · pinned";
