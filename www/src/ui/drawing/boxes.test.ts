import { expect, it } from "vitest";
import { colour, fontOf, paintOf, parsedColour, unlike } from "./attributes";
import { boxOf } from "./boxes";

const styled = (properties: Record<string, string>) => (name: string) => properties[name] ?? "";
const BOX = { x: 10, y: 20, width: 100, height: 50 };
const SIDES = ["top", "right", "bottom", "left"];

it("reads colours as browsers write them", () => {
  expect(parsedColour("rgb(1, 2, 255)")).toEqual({ hex: "#0102ff", alpha: 1 });
  expect(parsedColour("rgba(0, 0, 0, 0.5)")).toEqual({ hex: "#000000", alpha: 0.5 });
  expect(parsedColour("color(srgb 1 0.5 0 / 0.25)")).toEqual({ hex: "#ff8000", alpha: 0.25 });
  expect(parsedColour("none")).toBeNull();
  expect(parsedColour("rgb(x)")).toBeNull();
  expect(colour("fill", "rgba(1, 2, 3, 0.5)", "")).toEqual({ fill: "#010203", "fill-opacity": 0.5 });
  expect(colour("fill", 'url("http://a/b#stripes")', "")).toEqual({ fill: "url(#stripes)" });
});

it("writes lines as wide as they are seen", () => {
  const style = styled({
    fill: "none",
    stroke: "rgb(0, 0, 0)",
    "stroke-width": "2px",
    "stroke-dasharray": "4px, 6px",
    "vector-effect": "non-scaling-stroke",
  });
  expect(paintOf(style, 4)).toEqual({
    fill: "none",
    stroke: "#000000",
    "stroke-width": 0.5,
    "stroke-dasharray": "1 1.5",
  });
});

it("names a kind of font that every computer has", () => {
  expect(fontOf(styled({ "font-family": 'system-ui, "Segoe UI", sans-serif', "font-size": "14px" }))).toEqual(
    {
      "font-family": "sans-serif",
      "font-size": 14,
    },
  );
  expect(fontOf(styled({ "font-family": "ui-monospace, monospace", "font-size": "14px" }))).toMatchObject({
    "font-family": "monospace",
  });
});

it("says what words have lost of what is around them", () => {
  expect(unlike({ fill: "#111111" }, { fill: "#111111", "font-weight": "650" })).toEqual({
    "font-weight": "400",
  });
});

it("draws ground, ring and border of a box, and nothing of one that is not seen", () => {
  const borders = Object.fromEntries(
    SIDES.flatMap((side) => [
      [`border-${side}-style`, "solid"],
      [`border-${side}-width`, "2px"],
      [`border-${side}-color`, "rgb(1, 2, 3)"],
    ]),
  );
  const all = boxOf(
    styled({
      ...borders,
      "background-color": "rgb(255, 255, 255)",
      "border-top-left-radius": "4px",
      "box-shadow": "rgb(9, 9, 9) 0px 0px 0px 3px",
    }),
    BOX,
    () => "id",
  );
  expect(all).toEqual([
    '<rect x="8.5" y="18.5" width="103" height="53" rx="5.5" fill="none" stroke="#090909" stroke-width="3"/>',
    '<rect x="10" y="20" width="100" height="50" rx="4" fill="#ffffff"/>',
    '<rect x="11" y="21" width="98" height="48" rx="3" fill="none" stroke="#010203" stroke-width="2"/>',
  ]);
  const below = styled({
    "border-bottom-style": "solid",
    "border-bottom-width": "1px",
    "border-bottom-color": "rgb(1, 2, 3)",
  });
  expect(boxOf(below, BOX, () => "id")).toEqual([
    '<path d="M10 69.5L110 69.5" fill="none" stroke="#010203" stroke-width="1"/>',
  ]);
  expect(boxOf(styled({ "background-color": "rgba(0, 0, 0, 0)" }), BOX, () => "id")).toEqual([]);
});
