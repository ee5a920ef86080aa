import { effect } from "@preact/signals";
import { route } from "#document/link";
import { picture } from "./stage";

const PATIENCE_MS = 4000;

/**
 * Resolves when there is something on the canvas, so that the first picture does not wait for workers to load; or when
 * there is no canvas to wait for.
 */
export function whenFirstPicture(): Promise<void> {
  return new Promise((resolve) => {
    const timer = setTimeout(resolve, PATIENCE_MS);
    const stop = effect(() => {
      const { backend, points, settled, empty, preview } = picture.value;
      const drawn = preview || points > 0 || (settled && empty) || backend === "canvas";
      if (!drawn && route.value.page === "studio") return;
      clearTimeout(timer);
      // After the frame that holds the picture.
      setTimeout(() => {
        stop();
        resolve();
      });
    });
  });
}
