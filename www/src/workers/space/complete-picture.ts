import { spaceTask } from "./client";
import type { PictureRequest } from "./picture";

export type { PictureRequest, Shown } from "./picture";

/**
 * The complete picture, from a worker: for thumbnails, files and frames. Rejected with `{ code: "stopped" }` when
 * called off.
 */
export async function pictureOf(
  request: PictureRequest,
  options: { signal?: AbortSignal; lane?: 0 | 1 | 2 | 3 } = {},
): Promise<ImageData> {
  const { width, height, data } = await spaceTask("picture", request, options);
  return new ImageData(data, width, height);
}
