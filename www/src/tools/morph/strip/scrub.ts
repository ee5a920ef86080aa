import { locusView } from "#document/morph";
import { pause, setT } from "#document/playback";
import { replace, scene } from "#document/scene";

/** Moves in time by hand: what plays stops, and the picture is on the path again. */
export function scrubTo(t: number): void {
  pause();
  leavePoint();
  setT(Math.min(1, Math.max(0, t)));
}

/** A point that was picked off the path is let go; another family's plane gives way to the morph's. */
function leavePoint(): void {
  const { at, ...view } = locusView.peek();
  if (at === undefined && view.family === "morph") return;
  const { locus: _, ...rest } = scene.peek();
  replace(view.family === "morph" ? { ...rest, locus: view } : rest);
}
