import { pause, setT } from "../../../state/playback";

/** Moves in time by hand: what plays stops. */
export function scrubTo(t: number): void {
  pause();
  setT(Math.min(1, Math.max(0, t)));
}
