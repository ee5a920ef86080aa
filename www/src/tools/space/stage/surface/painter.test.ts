import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { NOTHING, type Painted, SpacePainter } from "./painter";
import { type Completed, type Surface, sameView, type Wanted } from "./surface";

/** A surface that takes down what is asked of it. */
class Fake implements Surface {
  readonly canvas = { remove() {} } as HTMLCanvasElement;
  readonly backend = "webgl2";
  readonly drawn: Wanted[] = [];
  readonly asked: { signal: AbortSignal; show: (completed: Completed) => void; end: () => void }[] = [];
  broken: string | null = null;
  freed = false;
  lost: (reason: string) => void = () => {};
  keeps = sameView;
  draw(wanted: Wanted): { points: number } {
    if (this.broken) throw new Error(this.broken);
    this.drawn.push(wanted);
    return { points: 1000 };
  }
  complete(_wanted: Wanted, signal: AbortSignal, onShown: (completed: Completed) => void): Promise<void> {
    return new Promise((resolve, reject) => {
      this.asked.push({ signal, show: onShown, end: resolve });
      signal.addEventListener("abort", () => reject({ code: "stopped", message: "" }));
    });
  }
  objectAt(): null {
    return null;
  }
  async pixels() {
    return { width: 0, height: 0, data: new Uint8ClampedArray() };
  }
  forceLoss(): void {
    this.lost("tried");
  }
  free(): void {
    this.freed = true;
  }
}

const surfaces: Fake[] = [];
const backends: string[] = [];
vi.mock("./open", () => ({
  openSurface: async (backend: string, onLost: (reason: string) => void) => {
    const surface = new Fake();
    surface.lost = onLost;
    surfaces.push(surface);
    backends.push(backend);
    return surface;
  },
}));

const host = { querySelectorAll: () => [], prepend() {} } as unknown as HTMLElement;
const sight = {} as Wanted["sight"];
const LIGHT = { paint: "map", side: 0, front: 0, ambient: 0, hollows: 0, fog: 0 } as const;
const wanted = (turn: number, more: Partial<Wanted> = {}): Wanted => ({
  sight,
  view: { target: [0, 0, 0], distance: 1, turn, tilt: 0, angle: 1 },
  light: LIGHT,
  palette: [],
  ground: "#ffffff",
  width: 4,
  height: 4,
  factor: 1,
  ...more,
});

let state: Painted = NOTHING;
async function opened(): Promise<SpacePainter> {
  const painter = new SpacePainter(host, {
    backend: "auto",
    onState: (now) => {
      state = now;
    },
  });
  await vi.advanceTimersByTimeAsync(0);
  return painter;
}
const frame = () => vi.advanceTimersByTimeAsync(17);
const rest = () => vi.advanceTimersByTimeAsync(200);
const only = () => surfaces[0] as Fake;

beforeEach(() => {
  vi.useFakeTimers();
  vi.stubGlobal("requestAnimationFrame", (then: () => void) => setTimeout(then, 16));
  vi.stubGlobal("cancelAnimationFrame", (id: number) => clearTimeout(id));
  surfaces.length = 0;
  backends.length = 0;
  state = NOTHING;
});
afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

test("it shows points at once, and the complete picture when nothing has changed for a while", async () => {
  const painter = await opened();
  painter.show(wanted(0));
  painter.show(wanted(0.1));
  await frame();
  // There are more changes than frames.
  expect(only().drawn).toHaveLength(1);
  expect(state).toMatchObject({ complete: false, points: 1000, backend: "webgl2" });
  expect(only().asked).toHaveLength(0);
  await rest();
  expect(only().asked).toHaveLength(1);
  only().asked[0]?.show({ empty: false });
  expect(state).toMatchObject({ complete: true, settled: false, points: 0, empty: false });
  only().asked[0]?.end();
  await rest();
  expect(state).toMatchObject({ complete: true, settled: true });
  // Nothing is drawn while nothing changes.
  expect(only().drawn).toHaveLength(1);
});

test("what has been asked for is called off when the view changes, and kept when only the light does", async () => {
  const painter = await opened();
  painter.show(wanted(0));
  await rest();
  painter.show(wanted(0, { light: { ...LIGHT, fog: 1 } }));
  await frame();
  expect(only().asked[0]?.signal.aborted).toBe(false);
  painter.show(wanted(0.5));
  // Before the next frame: by then, what it is made of may be gone.
  expect(only().asked[0]?.signal.aborted).toBe(true);
  await rest();
  expect(only().asked).toHaveLength(2);
  only().asked[1]?.show({ empty: true });
  only().asked[1]?.end();
  await frame();
  expect(state).toMatchObject({ complete: true, empty: true });
  painter.show(wanted(0.5, { light: { ...LIGHT, fog: 0.5 } }));
  await rest();
  expect(state).toMatchObject({ complete: true, settled: true });
  expect(only().asked).toHaveLength(2);
});

test("it is made, too, of what was there a moment ago and is there again", async () => {
  const painter = await opened();
  painter.show(wanted(0));
  await rest();
  painter.show(wanted(0.5));
  painter.show(wanted(0));
  await rest();
  expect(only().asked.map(({ signal }) => signal.aborted)).toEqual([true, false]);
});

test("a view that there is not is said in words, and the next one is drawn", async () => {
  const painter = await opened();
  only().broken = "The eye lies where it looks.";
  painter.show(wanted(0));
  await rest();
  expect(state).toMatchObject({ problem: "The eye lies where it looks.", complete: false });
  expect(only().asked).toHaveLength(0);
  only().broken = null;
  painter.show(wanted(0.1));
  await rest();
  expect(state.problem).toBeNull();
  expect(only().asked).toHaveLength(1);
});

test("a lost device is replaced, and after three losses is not asked for again", async () => {
  const painter = await opened();
  painter.show(wanted(0));
  await rest();
  for (let loss = 1; loss <= 3; loss++) {
    painter.forceLoss();
    await rest();
    expect(surfaces).toHaveLength(loss + 1);
    expect(surfaces[loss - 1]?.freed).toBe(true);
    expect(surfaces[loss]?.drawn).toHaveLength(1);
  }
  expect(backends).toEqual(["auto", "auto", "auto", "canvas"]);
});

test("closed, it lets everything go", async () => {
  const painter = await opened();
  painter.show(wanted(0));
  await rest();
  painter.close();
  expect(only().freed).toBe(true);
  expect(only().asked[0]?.signal.aborted).toBe(true);
});
