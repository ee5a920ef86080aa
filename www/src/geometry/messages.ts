/** What is said of numbers and maps. */

export const allInsideOut = (undoes: string) => `All of it is turned inside out. “${undoes}” undoes this.`;
export const foldedOver = (percent: number, undoes: string) =>
  `About ${percent}% of its box is folded over: there, mirrored parts lie on top of others. “${undoes}” undoes this.`;

export const allPointsSame = (count: string) => `All ${count} points are the same to the last digit.`;
export const pointsWithoutSize = "All points are in one place, so there is no size to compare with.";
export const apartByRounding = (count: string, power: string) =>
  `${count} points: apart by less than 10${power} of its size, which is rounding.`;
export const apartBy = (count: string, power: string) =>
  `${count} points: apart by up to 10${power} of its size.`;

export const polygonFills = (sides: number) =>
  `${sides} times |s|² is 1 or more, so there is no room for all pieces to be apart, and two of them meet. A turn by 1/${sides} maps the shape onto itself, and ${sides} is prime, so all pieces are joined.`;

export const targetNeedsTwoMaps = "The game needs a shape of at least two maps.";
export const targetTooManyMaps = (count: number, most: number) =>
  `This shape has ${count} maps. The game is for shapes of 2 to ${most} maps.`;
export const targetIsFlat = (map: number) =>
  `Map ${map} flattens the shape: its cells are lines, which are too thin to hit.`;
