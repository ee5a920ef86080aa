import { expect, it } from "vitest";
import { escaped, saidOf, svgFile, svgPen, tag } from "./svg";

it("writes what was given as text, never as more elements", () => {
  const hostile = `<script>alert("1")</script>&\u0000\ud800\u0007 x`;
  const file = svgFile(
    { box: [0, 0, 10.001, 5], title: hostile, about: hostile, style: { fill: hostile } },
    tag("text", { x: 1, y: undefined, "data-a": hostile }, escaped(hostile)),
  );
  expect(file.match(/<(?!\/)\w+/g)).toEqual(["<svg", "<title", "<desc", "<text"]);
  expect(file).toContain('viewBox="0 0 10 5" width="10" height="5"');
  expect(file).toContain("<title>&lt;script&gt;alert(&quot;1&quot;)&lt;/script&gt;&amp; x</title>");
  expect(file).not.toContain("undefined");
  expect(file.endsWith("</text>\n</svg>\n")).toBe(true);
  expect(svgFile({ box: [0, 0, 1, 1] }, tag("g", {})).split("\n")).toHaveLength(4);
});

it("draws as a canvas does", () => {
  const pen = svgPen();
  pen.strokeStyle = "#123456";
  pen.beginPath();
  pen.moveTo(1, 2);
  pen.lineTo(3.456, 4);
  pen.stroke();
  pen.font = "36px system-ui, sans-serif";
  pen.textAlign = "right";
  pen.textBaseline = "middle";
  pen.fillText("−1 < u", 5, 6);
  expect(pen.parts).toEqual([
    '<path d="M1 2L3.46 4" fill="none" stroke="#123456" stroke-width="1"/>',
    '<text x="5" y="6" dy="0.35em" text-anchor="end" font-family="sans-serif" font-size="36" fill="#1d1e22">−1 &lt; u</text>',
  ]);
});

it("says of how many pieces a drawing is made, before it is saved", () => {
  const about = "6561 pieces of one size in 3 paths, one for each map. Made by Frond.";
  expect(saidOf(svgFile({ box: [0, 0, 1, 1], about }))).toBe(
    "6,561 pieces of one size in 3 paths, one for each map.",
  );
  expect(saidOf("x,y\n1,2\n")).toBe("");
});
