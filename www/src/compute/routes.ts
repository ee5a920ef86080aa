/** Ways to bring the present pair of shapes to a morph. */
import { computed, effect, type ReadonlySignal, signal, untracked } from "@preact/signals";
import { wordsOf } from "#document/notice";
import { scene } from "#document/scene";
import { remade, sameWeighted, weighted } from "#geometry/maps/weighted";
import type { Route, Shape } from "#wasm/api";
import { cancel, epoch, submit } from "#workers/pool/engine";
import { single } from "#workers/pool/protocol";
import * as messages from "./messages";

/** Ways to bring two shapes to a morph. */
export interface Routes {
  /** The pair that they were looked for. */
  a: Shape;
  b: Shape;
  /** Null while they are looked for. */
  list: Route[] | null;
  problem: string | null;
}

const latest = signal<Routes | null>(null);
const a = computed(() => scene.value.a);
const b = computed(() => scene.value.b);

/** About the present pair, or the one from which a route has led to it; null where it was not asked for. */
export const routes: ReadonlySignal<Routes | null> = computed(() => {
  const now = latest.value;
  if (!now) return null;
  const mine = (from: Shape, to: Shape) => sameWeighted(from, a.value) && sameWeighted(to, b.value);
  const leadsHere = (route: Route) =>
    mine(remade(now.a, route.from, route.fromProbabilities), remade(now.b, route.to, route.toProbabilities));
  return mine(now.a, now.b) || now.list?.some(leadsHere) ? now : null;
});

export function lookForRoutes(): void {
  const mine: Routes = { a: a.peek(), b: b.peek(), list: null, problem: null };
  latest.value = mine;
  const set = (change: Partial<Routes>) => {
    const now = latest.peek();
    if (now?.a === mine.a && now.b === mine.b) latest.value = { ...mine, ...change };
  };
  submit(
    single<"routes">(
      "routes",
      24,
      {
        kind: "routes",
        from: weighted(mine.a.maps, mine.a.weights),
        to: weighted(mine.b.maps, mine.b.weights),
      },
      {
        accept: (list) => set({ list }),
        fail: (error) => set({ list: [], problem: messages.routesFailed(wordsOf(error)) }),
      },
    ),
  );
}

export function scheduleRoutes(): void {
  const forget = (when: (now: Routes) => boolean) => {
    const now = latest.peek();
    if (!now || !when(now)) return;
    cancel("routes");
    latest.value = null;
  };
  effect(() => {
    const stands = routes.value !== null;
    untracked(() => forget(() => !stands));
  });
  effect(() => {
    epoch.value;
    untracked(() => forget(({ list }) => list === null));
  });
}
