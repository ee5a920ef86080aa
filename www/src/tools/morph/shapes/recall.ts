/**
 * Shapes of a link that a way across has matched. A link has their maps and does not say whence they are: the same ways
 * are listed again, for the shapes of the gallery whose names they have.
 */
import { computed, effect } from "@preact/signals";
import { originOf } from "#document/presets";
import { scene } from "#document/scene";
import { sameMaps } from "#geometry/maps/same-maps";
import type { Ifs, Route, Scene, Shape } from "#wasm/api";
import { submit } from "#workers/pool/engine";
import { single, type Task } from "#workers/pool/protocol";
import { learnMatched } from "./matched";

/** Lists ways between two shapes. */
type Ask = (task: Task<"ways" | "routes">) => Promise<Route[]>;
type Pair = Pick<Scene, "a" | "b">;

/** As many as are tried where a path breaks. */
const MOST_WAYS = 240;
/** Rest before it begins: whoever edits a shape knows it. */
const REST_MS = 500;
/** When all else is done. */
const PRIORITY = 2;

/** Whether the maps of both are those of a way between the shapes of the gallery that have their names. */
export async function isMatched({ a, b }: Pair, ask: Ask): Promise<boolean> {
  const [p, q] = [originOf(a), originOf(b)];
  if (!(p && q)) return false;
  // They may have been swapped since.
  for (const [first, last, from, to] of [[p, q, a, b] as const, [q, p, b, a] as const]) {
    const [plainFirst, plainLast]: [Ifs, Ifs] = [{ maps: first.maps }, { maps: last.maps }];
    for (const task of [
      { kind: "ways", from: plainFirst, to: plainLast, limit: MOST_WAYS },
      { kind: "routes", from: plainFirst, to: plainLast },
    ] as const) {
      const all = await ask(task);
      if (all.some((route) => sameMaps(route.from, from.maps) && sameMaps(route.to, to.maps))) return true;
    }
  }
  return false;
}

const bySelf: Ask = (task) =>
  new Promise((resolve) => {
    submit(single("recall", PRIORITY, task, { accept: resolve, fail: () => resolve([]) }));
  });

let timer: ReturnType<typeof setTimeout> | null = null;
/** What has been asked about. */
const asked = new WeakSet<Shape>();

/** From now on it is looked whether shapes that are not the gallery's were matched, once they rest. */
export function recallShapes(): void {
  effect(() => {
    if (unknown.value.length === 0) return;
    if (timer) clearTimeout(timer);
    timer = setTimeout(() => void look(scene.peek()), REST_MS);
  });
}

const [a, b] = [computed(() => scene.value.a), computed(() => scene.value.b)];
const unknown = computed(() => [a.value, b.value].filter((shape) => shape.preset === undefined));

async function look({ a, b }: Pair): Promise<void> {
  const open = [a, b].filter((shape) => shape.preset === undefined);
  if (open.every((shape) => asked.has(shape))) return;
  for (const shape of open) asked.add(shape);
  if (await isMatched({ a, b }, bySelf)) for (const shape of open) learnMatched(shape);
}
