/** What the address may say before the `#`. */
import type { CardChoice } from "#compute/locus/card/trial";
import type { PainterBackend } from "#stage/surface/painter";

export type Plays = "on" | "once" | "still";

export interface Parameters {
  backend: "auto" | PainterBackend;
  /** How many workers; null for as many as the machine has room for. */
  workers: number | null;
  /** What decides loci besides the workers. */
  card: CardChoice;
  /** Whether what moves is to play at once, on and on or there and back, or to stand still; null if nothing is said. */
  play: Plays | null;
}

declare global {
  /** What draws where the address does not say: for the tests, whose browsers have no card. */
  var frondBackend: string | undefined;
}

const BACKENDS: readonly string[] = ["webgpu", "webgl2", "canvas"];
const CARDS: readonly string[] = ["auto", "software", "none"];
const PLAYS: readonly Plays[] = ["once", "still"];

/** A machine without WebGPU has no card for the locus, either. */
const cardBeside = (backend: string): CardChoice =>
  backend === "webgl2" || backend === "canvas" ? "none" : "auto";

/**
 * `?play`, `?play=once` and `?play=still`: as somebody shared it. `?backend=webgl2`, `?workers=0`, `?card=none`: for
 * trying the page as another machine would run it.
 */
export function readParameters(search: string): Parameters {
  const query = new URLSearchParams(search);
  const backend = query.get("backend") ?? globalThis.frondBackend ?? "";
  const card = query.get("card") ?? "";
  return {
    backend: BACKENDS.includes(backend) ? (backend as PainterBackend) : "auto",
    workers: /^[0-8]$/.test(query.get("workers") ?? "") ? Number(query.get("workers")) : null,
    play: query.has("play") ? (PLAYS.find((how) => how === query.get("play")) ?? "on") : null,
    card: CARDS.includes(card) ? (card as CardChoice) : cardBeside(backend),
  };
}
