import { describe, expect, it } from "vitest";
import { fillPath, outlinePaths, place, type Sink } from "./outline";

type Stroke = [number, number][];

/** Notes what is drawn. */
class Drawn implements Sink {
  readonly strokes: Stroke[] = [];
  closed = 0;
  moveTo(x: number, y: number): void {
    this.strokes.push([[x, y]]);
  }
  lineTo(x: number, y: number): void {
    this.strokes.at(-1)?.push([x, y]);
  }
  closePath(): void {
    this.closed++;
  }
}

const FRAME = { view: { x: 0, y: 0, scale: 100 }, width: 200, height: 100 };
const square = (half: number) => new Float64Array([-half, -half, half, -half, half, half, -half, half]);

/** Twice the area, with a sign. */
function area(stroke: Stroke | undefined): number {
  return (stroke ?? []).reduce((sum, [x, y], i, all) => {
    const [u, v] = all[(i + 1) % all.length] ?? [0, 0];
    return sum + x * v - u * y;
  }, 0);
}

describe("a curve on a canvas", () => {
  it("has y down, the middle of the view in the middle", () => {
    const { points, inside } = place(square(0.25), FRAME);
    expect([...points]).toEqual([75, 75, 125, 75, 125, 25, 75, 25]);
    expect(inside).toBe(true);
  });

  it("is one closed line where all of it is on the canvas", () => {
    const paths = outlinePaths(place(square(0.25), FRAME), () => new Drawn());
    expect(paths.size).toBe(1);
    expect(paths.get(0)?.strokes).toEqual([
      [
        [75, 75],
        [125, 75],
        [125, 25],
        [75, 25],
      ],
    ]);
    expect(paths.get(0)?.closed).toBe(1);
  });

  it("fills all that is seen when it lies around the canvas, and strokes nothing", () => {
    const placed = place(square(1e6), FRAME);
    expect(placed.inside).toBe(false);
    const fill = new Drawn();
    fillPath(fill, placed);
    const all = (200 + 512) * (100 + 512);
    expect(Math.abs(area(fill.strokes[0]))).toBeCloseTo(2 * all, 6);
    expect(outlinePaths(placed, () => new Drawn()).size).toBe(0);
  });

  it("fills nothing when it lies beside the canvas", () => {
    const placed = place(new Float64Array([1e3, 1e3, 1e3 + 1, 1e3, 1e3, 1e3 + 1]), FRAME);
    const fill = new Drawn();
    fillPath(fill, placed);
    expect(fill.strokes).toEqual([]);
    expect(outlinePaths(placed, () => new Drawn()).size).toBe(0);
  });

  it("cuts a segment that crosses the canvas where it leaves what is drawn, to the digit", () => {
    // A wedge whose sides are a million pixels long: the straight one crosses the middle.
    const placed = place(new Float64Array([-1e4, 0, 1e4, 0, 0, 1e4]), FRAME);
    const [drawn] = outlinePaths(placed, () => new Drawn()).values();
    expect(drawn?.strokes).toEqual([
      [
        [-256, 50],
        [456, 50],
      ],
    ]);
    const fill = new Drawn();
    fillPath(fill, placed);
    // Above the line, which is up: y from -256 to 50.
    expect(Math.abs(area(fill.strokes[0]))).toBeCloseTo(2 * (200 + 512) * (256 + 50), 6);
  });

  it("keeps the kinds of its segments apart, and joins neighbours of one kind", () => {
    const paths = outlinePaths(
      place(square(0.25), FRAME),
      () => new Drawn(),
      (i) => (i < 2 ? 7 : 3),
    );
    expect([...paths.keys()]).toEqual([7, 3]);
    expect(paths.get(7)?.strokes).toHaveLength(1);
    expect(paths.get(7)?.strokes[0]).toHaveLength(3);
    expect(paths.get(3)?.strokes[0]).toEqual([
      [125, 25],
      [75, 25],
      [75, 75],
    ]);
  });

  it("takes no vertices, and a single one", () => {
    for (const vertices of [new Float64Array(0), new Float64Array([0, 0])]) {
      const placed = place(vertices, FRAME);
      const fill = new Drawn();
      fillPath(fill, placed);
      expect(outlinePaths(placed, () => new Drawn()).size).toBeLessThan(2);
    }
  });
});
