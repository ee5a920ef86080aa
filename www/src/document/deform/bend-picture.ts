import { inBox } from "#geometry/mesh";
import { openTool } from "../tool";
import { boxAround, changeDeformation } from "./bend";
import { type Photograph, pictureMaps, showPicture } from "./picture";

/** Takes a picture under the grid, which lies around it: one undo step, then the tool. */
export function bendPicture(picture: Photograph): void {
  showPicture(picture);
  const box = boxAround(pictureMaps.peek());
  changeDeformation((now) => inBox({ ...now, on: true, subject: "picture" }, box));
  openTool("deform");
}
