/** Outlines of pictures, and closed curves near outlines. */
import { curveJson, pointsCsv, splineJson } from "#format/curve-files";
import { INK } from "#style/colours";
import type { Scene } from "#wasm/api";
import type { PreparedOutline } from "#workers/fit/curve";
import { kindOf, number, type Options, Refusal, whole } from "../options";
import { answer } from "../plan";
import { progress } from "../progress";
import type { System } from "../system";
import { outlineOf } from "./outline";

export async function trace(word: string, options: Options, system: System): Promise<number> {
  const kind = kindOf(options, ["svg", "csv"], "svg");
  const { points } = await outlineOf(word, options, system);
  await answer(kind === "csv" ? pointsCsv(points) : outlineSvg(points), options, system);
  system.tell(`${points.length / 2} points`);
  return 0;
}

/** In the units of the outline, y down as in every SVG. */
function outlineSvg(points: Float64Array): string {
  let [x0, y0, x1, y1] = [
    Number.POSITIVE_INFINITY,
    Number.POSITIVE_INFINITY,
    Number.NEGATIVE_INFINITY,
    Number.NEGATIVE_INFINITY,
  ];
  const corners: string[] = [];
  for (let i = 0; i < points.length; i += 2) {
    const [x, y] = [points[i] ?? 0, -(points[i + 1] ?? 0)];
    [x0, y0, x1, y1] = [Math.min(x0, x), Math.min(y0, y), Math.max(x1, x), Math.max(y1, y)];
    corners.push(`${short(x)} ${short(y)}`);
  }
  const box = [x0, y0, x1 - x0, y1 - y0].map(short).join(" ");
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="${box}">\n<path fill="${INK}" d="M${corners.join("L")}Z"/>\n</svg>\n`;
}

const short = (x: number) => Number(x.toPrecision(9));

const KINDS = ["link", "svg", "json", "csv"] as const;
type Files = Readonly<Record<(typeof KINDS)[number], () => string>>;

export async function fit(word: string, options: Options, system: System): Promise<number> {
  const kind = kindOf(options, KINDS, "link");
  if (options["numbers"] !== undefined && options["bytes"] !== undefined)
    throw new Refusal("Say --numbers or --bytes, and not both.");
  const numbers = whole(options, "numbers", 12, 2000, 260);
  const bytes = options["bytes"] === undefined ? null : whole(options, "bytes", 32, 4000, 150);
  const smoothing = number(options, "smoothing", 0, 1, 0);
  const { name, points } = await outlineOf(word, options, system);
  const { prepareOutline } = await system.fit();
  const outline: PreparedOutline = prepareOutline(points, smoothing);
  const meter = progress(system);
  const onProgress = (share: number) => meter.say(share);
  const { encodeScene, defaultScene } = await system.draw();
  const linkTo = (fitted: NonNullable<Scene["fit"]>) =>
    `#${encodeScene({ ...defaultScene(), tool: "fit", fit: fitted })}`;
  const curves = await system.curve();
  let files: Files;
  let told: string;
  if (bytes === null) {
    const { curve, figures } = await system.pool().fitCurve(outline.points, { numbers }, { onProgress });
    const facts = curves.curveFacts(curve);
    told = `${facts.numbers} numbers, ${facts.copies} copies, ${percent(figures.rms)} of the diagonal off`;
    files = {
      link: () => linkTo({ mode: "outline", model: "closed", numbers, smoothing, curve: { name, curve } }),
      svg: () => curves.curveSvg(curve, undefined),
      csv: () => curves.curveCsv(curve, undefined),
      json: () => curveJson(name, curve, curves.curveMaps(curve), figures),
    };
  } else {
    const made = await system.pool().fitWithin(outline.points, bytes, { onProgress });
    const { word: packed, figures, corners, bends } = made;
    told = `${made.bytes.length} bytes, ${corners} corners, ${bends} bends, ${percent(figures.rms)} of the diagonal off`;
    const spline = { name, word: packed };
    files = {
      link: () => linkTo({ mode: "outline", model: "spline", numbers, bytes, smoothing, spline }),
      svg: () => curves.splineSvg(packed, undefined),
      csv: () => pointsCsv(made.points),
      json: () => splineJson(name, packed, curves.unpackSpline(packed), figures),
    };
  }
  meter.end();
  await answer(files[kind](), options, system);
  system.tell(told);
  return 0;
}

const percent = (part: number) => `${Number(part.toPrecision(2))} %`;
