/** What is said of the two shapes and their gallery. */

export const twoShapes = "The two shapes";
export const swapped = (a: string, b: string) => `Swapped: from ${a} to ${b}.`;
export const editMapsOf = (shape: string) => `Edit the maps of ${shape}`;
export const moreFor = (shape: string) => `More for shape ${shape}`;
export const chooseAnother = "Choose another …";
export const newShape = "New shape …";
export const moveRotateOrScale = "Move, rotate or scale it";
export const mapsAsText = "Maps as text …";
export const saveThisShape = "Save this shape";
export const isKept = (name: string) => `${name} is saved. Find it in the gallery under Yours.`;
export const alsoAs = (shape: string) => `Use as ${shape} too`;
export const atBothEnds = (name: string) => `${name} is now both shapes.`;

export const shapeNow = (shape: string, name: string) => `Shape ${shape} is now ${name}.`;
export const shape = (shape: string) => `Shape ${shape}`;
export const eachMadeSmallerCopies = "Each is made of smaller copies of itself. You can edit its maps later.";
export const otherIsOutline = (shape: string, name: string) =>
  `Shape ${shape} is ${name}, an outline. Outlines morph only into outlines.`;
export const replacesOutline = (shape: string, system: string, outline: string) =>
  `These do not morph into outlines. If you choose one, shape ${shape} becomes ${system} instead of ${outline}.`;

export const newShape2 = "New shape";

export const staysInOnePiece = (other: string | number) => `Stays in one piece with ${other}`;
export const canStayInOne = (other: string | number) =>
  `Can stay in one piece with ${other}; Frond will look for the pairing`;
