/** A hand laid on a shape: what its sliders say, and from where. In the plane and in space. */
import { computed, type ReadonlySignal, signal } from "@preact/signals";
import { wordsOf } from "#document/notice";
import { endGesture } from "#document/scene";
import { AT_REST, type Kind, type Numbers, nearlySame, transformOf } from "#geometry/maps/hand";
import type { Row } from "#geometry/maps/row";
import type { MapRow3, Point3 } from "#wasm/api";

interface Ball {
  /** Of two or three numbers. */
  centre: readonly number[];
  radius: number;
}

/** What can be taken in hand. */
export interface InHand<Map extends Row> {
  axes: readonly ("x" | "y" | "z")[];
  /** Which one it is: sliders that were laid on another are at rest. */
  id: () => string | number;
  identity: Map;
  /** All that was done to it. */
  moved: ReadonlySignal<Map>;
  /** Round it as it is shown, which may lag behind; null where it has no attractor. */
  ball: ReadonlySignal<Ball | null>;
  /** Round it as it is. */
  ballNow: () => Ball | null;
  /** A transform of space, as one of its own. */
  transform: (by: MapRow3) => Map;
  /** First `inner`, then `outer`. */
  compose: (outer: Map, inner: Map) => Map;
  /** Puts it there, all in one transform; null: where it was. Throws where that cannot be: nothing changes. */
  place: (put: Map | null, options?: { gesture?: string }) => void;
}

interface Hold<Map> {
  id: string | number;
  kind: Kind;
  base: Map;
  centre: Point3;
  radius: number;
  numbers: Numbers;
  /** Where that has put it. */
  put: Map;
}

export type Hand<Map extends Row> = ReturnType<typeof handOn<Map>>;

/** The state of its sliders: at rest as soon as something else has moved it. */
export function handOn<Map extends Row>(thing: InHand<Map>) {
  const held = signal<Hold<Map> | null>(null);
  const kind = signal<Kind | "matrix">("turn");
  const about = signal<"middle" | "origin">("middle");
  const hold = computed(() => {
    const now = held.value;
    const goes = now && now.id === thing.id() && now.kind === kind.value;
    return goes && nearlySame(now.put, thing.moved.value) ? now : null;
  });

  /** How far sliders of lengths reach. */
  const reach = computed(() => {
    const radius = hold.value?.radius ?? thing.ball.value?.radius ?? 1;
    return 3 * 10 ** Math.ceil(Math.log10(Math.max(radius, 1e-9)) - 0.3);
  });

  function change(what: Kind, name: string, value: number): string | undefined {
    const { centre, radius } = hold.peek() ?? thing.ballNow() ?? { centre: [0, 0, 0], radius: 1 };
    const { base, numbers } = hold.peek() ?? { base: thing.moved.peek(), numbers: AT_REST[what] };
    const next = { ...numbers, [name]: value };
    const [x = 0, y = 0, z = 0] = centre;
    const fixed: Point3 = about.peek() === "middle" ? [x, y, z] : [0, 0, 0];
    try {
      const put = thing.compose(thing.transform(transformOf(what, next, fixed)), base);
      thing.place(put, { gesture: `hand ${what} ${name}` });
      held.value = { id: thing.id(), kind: what, base, centre: [x, y, z], radius, numbers: next, put };
      return undefined;
    } catch (problem) {
      return wordsOf(problem);
    }
  }

  /** From here on: what the sliders have done stays, and they are at rest. */
  function letGo(): void {
    endGesture();
    held.value = null;
  }

  return { ...thing, kind, about, hold, reach, change, letGo };
}
