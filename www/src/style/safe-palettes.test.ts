import { expect, it } from "vitest";
import { SAFE } from "./safe-palettes";

/** What is left of red, green and blue for eyes that lack one kind of cones: Machado, Oliveira and Fernandes 2009. */
const EYES = {
  protanopia: [0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998],
  deuteranopia: [0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.01182, 0.04294, 0.968881],
  tritanopia: [1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367, 0.3039],
};
type Triple = [number, number, number];

function linear(colour: string): Triple {
  const part = (at: number) => {
    const c = Number.parseInt(colour.slice(at, at + 2), 16) / 255;
    return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
  };
  return [part(1), part(3), part(5)];
}

const times = (m: readonly number[], [x, y, z]: Triple): Triple => {
  const row = (i: number) => (m[i] ?? 0) * x + (m[i + 1] ?? 0) * y + (m[i + 2] ?? 0) * z;
  return [row(0), row(3), row(6)];
};

/** Oklab (Ottosson 2020): distances are about as they are seen. */
function oklab(rgb: Triple): Triple {
  const cones = times(
    [
      0.4122214708, 0.5363325363, 0.0514459929, 0.2119034982, 0.6806995451, 0.1073969566, 0.0883024619,
      0.2817188376, 0.6299787005,
    ],
    rgb,
  ).map(Math.cbrt) as Triple;
  return times(
    [
      0.2104542553, 0.793617785, -0.0040720468, 1.9779984951, -2.428592205, 0.4505937099, 0.0259040371,
      0.7827717662, -0.808675766,
    ],
    cones,
  );
}

/** The least distance of two of these colours for such eyes. */
function nearest(colours: readonly string[], eyes: readonly number[]): number {
  const seen = colours.map((colour) => {
    const [r, g, b] = times(eyes, linear(colour)).map((c) => Math.min(1, Math.max(0, c))) as Triple;
    return oklab([r, g, b]);
  });
  const distances = seen.flatMap((p, i) =>
    seen.slice(0, i).map((q) => Math.hypot(...p.map((x, k) => x - (q[k] ?? 0)))),
  );
  return Math.min(...distances);
}

/** Three times what is just noticed, 0.02. */
const APART = 0.06;

it.each(
  SAFE.flatMap(({ name, colours }) =>
    Object.entries(EYES).map(([eyes, m]) => [name, eyes, colours, m] as const),
  ),
)("%s is told apart with %s", (_, __, colours, eyes) => {
  expect(nearest(colours, eyes)).toBeGreaterThan(APART);
});

it("leaves greys as they are, whatever eyes see them", () => {
  for (const eyes of Object.values(EYES))
    for (const part of times(eyes, linear("#808080"))) expect(part).toBeCloseTo(linear("#808080")[0], 4);
});

it("finds red and green that are taken for each other", () => {
  expect(nearest(["#b05a00", "#7a7000"], EYES.protanopia)).toBeLessThan(APART);
});
