import { expect, it } from "vitest";
import type { MapRow } from "#wasm/api";
import { symmetriesOf } from "./symmetries";

const half = (x: number, y: number): MapRow => [0.5, 0, 0, 0.5, x, y];
const H = Math.sqrt(3) / 4;

it("knows the symmetries of the gasket, of the carpet, and of the Koch curve", () => {
  const gasket = [half(0, 0), half(0.5, 0), half(0.25, H)];
  expect(symmetriesOf(gasket)).toEqual({ turns: 3, mirrors: [30, 90, 150] });
  const carpet = [0, 1, 2, 3, 5, 6, 7, 8].map(
    (i): MapRow => [1 / 3, 0, 0, 1 / 3, (i % 3) / 3, Math.floor(i / 3) / 3],
  );
  // The middle was number 4.
  const ring = [...carpet.filter(([, , , , e, f]) => !(e === 1 / 3 && f === 1 / 3)), carpet[4] as MapRow];
  expect(symmetriesOf(ring.filter((map, i) => ring.indexOf(map) === i))).toEqual({
    turns: 4,
    mirrors: [0, 45, 90, 135],
  });
  const third = 1 / 3;
  const koch: MapRow[] = [
    [third, 0, 0, third, 0, 0],
    [third / 2, (-third * Math.sqrt(3)) / 2, (third * Math.sqrt(3)) / 2, third / 2, third, 0],
    [
      third / 2,
      (third * Math.sqrt(3)) / 2,
      (-third * Math.sqrt(3)) / 2,
      third / 2,
      0.5,
      third * (Math.sqrt(3) / 2),
    ],
    [third, 0, 0, third, 2 * third, 0],
  ];
  expect(symmetriesOf(koch)).toEqual({ turns: 1, mirrors: [90] });
});

it("knows a half turn, none where there is none, and holds out where maps have no fixed points", () => {
  const twin: MapRow[] = [
    [0.5, -0.5, 0.5, 0.5, 0, 0],
    [0.5, -0.5, 0.5, 0.5, 1, 0],
  ];
  expect(symmetriesOf(twin)).toEqual({ turns: 2, mirrors: [] });
  expect(symmetriesOf([half(0, 0), [0.3, 0.1, 0, 0.4, 2, 1]])).toEqual({ turns: 1, mirrors: [] });
  expect(symmetriesOf([[1, 0, 0, 1, 1, 0], half(0, 0)])).toEqual({ turns: 1, mirrors: [] });
  expect(symmetriesOf([half(0, 0)])).toEqual({ turns: 1, mirrors: [] });
});
