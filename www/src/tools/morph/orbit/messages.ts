/** What is said of a point that is followed. */

export const followedPoint = "The followed point";
export const selectedPointArrowKeys = "The selected point: arrow keys move it, Shift for finer steps";

export const followPoint = "Follow a point";
export const done = "Done";
export const whatToDoWith = "What to do with the point";
export const applyMaps = "Apply maps";
export const eachMapTakesPoint = "Each map takes the point to another place";
export const address = "Address";
export const readAddressPieceContains =
  "Read the address: which piece contains the point, and which piece of that?";
export const reachCell = "Reach a cell";
export const gameChooseThrowsLead = "A game: choose the throws that lead into the framed cell";
export const reachFramedCellIn =
  "Reach the framed cell in as few throws as you can. Press a number, its key, or a piece in the picture.";
export const lessonOnThisGame = "Lesson on this game";
export const clickPictureToChoose = "Click the picture to choose a point, or drag the ring.";
export const whatAddress = "What is an address?";

export const shapeDeformedSoPoints =
  "The shape is deformed, so its points are not where the maps take them. Turn off the deformation in Deform to follow a point.";
export const theseMapsHaveNo =
  "These maps have no attractor: together they do not contract. Change the maps first.";
