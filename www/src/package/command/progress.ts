/** How far the command is, and how long it will take: one line where somebody watches, else a line now and then. */
import type { System } from "./system";

/** Milliseconds between two words of it. */
const WATCHED_MS = 200;
const UNWATCHED_MS = 10_000;
/** Before so many milliseconds nobody knows how long it takes. */
const UNSURE_MS = 1500;

/** `say` is told what part is done, and in words what that is. */
export function progress({ now, tell, rewrite }: Pick<System, "now" | "tell" | "rewrite">) {
  const began = now();
  let last = rewrite ? Number.NEGATIVE_INFINITY : began;
  return {
    say(share: number, words = `${Math.round(100 * share)} %`): void {
      const at = now();
      if (share >= 1 || at - last < (rewrite ? WATCHED_MS : UNWATCHED_MS)) return;
      last = at;
      const passed = at - began;
      const left = share > 0 && passed >= UNSURE_MS ? `, ${timeLeft((passed / share - passed) / 1000)}` : "";
      (rewrite ?? tell)(`${words}${left}`);
    },
    /** Takes the line away. */
    end: () => rewrite?.(""),
  };
}

/** Rounded as nobody minds: "about 40 s left", "about 3 min left", "about 1 h 20 min left". */
export function timeLeft(seconds: number): string {
  if (seconds < 60) return `about ${Math.max(1, Math.round(seconds))} s left`;
  const minutes = Math.round(seconds / 60);
  if (minutes < 60) return `about ${minutes} min left`;
  const [hours, rest] = [Math.floor(minutes / 60), minutes % 60];
  return `about ${hours} h${rest > 0 ? ` ${rest} min` : ""} left`;
}
