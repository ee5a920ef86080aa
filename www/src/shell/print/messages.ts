/** What the print view says. */

export const thisPictureTakesMoment =
  "This picture takes a moment. Choose “Print” in the “Save” menu, which waits for it.";
export const savePictureFromSave = "Save the picture from the “Save” menu, and print that file.";
export const frondSceneInSpace = "Frond: a scene in space";
export const frondFractalCurve = "Frond: a fractal curve";
export const toAt = (name: string, name2: string, t: string) => `${name} to ${name2}, at ${t}`;
