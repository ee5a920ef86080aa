import { expect, test } from "vitest";
import { drawAxes, MARGIN } from "./axes";

/** Remembers what is written, and where. */
function pen() {
  const written: [string, number, number][] = [];
  const nothing = () => {};
  const context = {
    fillRect: nothing,
    strokeRect: nothing,
    beginPath: nothing,
    moveTo: nothing,
    lineTo: nothing,
    stroke: nothing,
    fillText: (text: string, x: number, y: number) => void written.push([text, x, y]),
    fillStyle: "",
    strokeStyle: "",
    lineWidth: 0,
    font: "",
    textAlign: "left" as CanvasTextAlign,
    textBaseline: "top" as CanvasTextBaseline,
  };
  return { context, written };
}

test("numbers stand where they are, v upwards, and both axes are named", () => {
  const { context, written } = pen();
  drawAxes(context, 300, { u0: -1, u1: 2, v0: -1, v1: 2 }, { across: "u", up: "v" }, () => {});
  const across = written
    .filter(([, , y]) => y > MARGIN.top + 300)
    .map(([text, x]) => [text, x - MARGIN.left]);
  expect(across).toEqual([
    ["−1", 0],
    ["0", 100],
    ["1", 200],
    ["2", 300],
    ["u", 150],
  ]);
  const up = written.slice(across.length).map(([text, , y]) => [text, y - MARGIN.top]);
  expect(up).toEqual([
    ["−1", 300],
    ["0", 200],
    ["1", 100],
    ["2", 0],
    ["v", 150],
  ]);
});
