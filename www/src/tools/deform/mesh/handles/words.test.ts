import { describe, expect, it } from "vitest";
import { handleWords, movedWords } from "./words";

describe("what is said of a handle", () => {
  it("counts from the left and from below", () => {
    const mesh = { columns: 4, rows: 4, box: [0, 0, 1, 1] as [number, number, number, number], moves: [] };
    expect(handleWords(mesh, 0)).toBe("Column 1, row 1: at rest");
    expect(handleWords({ ...mesh, moves: Array.from({ length: 32 }, (_, i) => i / 100) }, 9)).toBe(
      "Column 2, row 3: moved 0.18 right, 0.19 up",
    );
  });

  it("says the way, and what is small by its first figures", () => {
    expect(movedWords(-0.5, 0)).toBe("moved 0.5 left");
    expect(movedWords(0, -12.25)).toBe("moved 12.25 down");
    expect(movedWords(0.00123, 0)).toBe("moved 0.0012 right");
    expect(movedWords(0, 0)).toBe("at rest");
    expect(movedWords(Number.NaN, -0)).toBe("at rest");
  });
});
