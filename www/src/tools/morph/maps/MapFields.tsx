import { useRef } from "preact/hooks";
import { formulaAt, formulasRead } from "#document/editing/exact";
import { digitsApart } from "#format/numbers";
import { compose, decompose, type Parts } from "#geometry/maps/affine2";
import { NumberField } from "#ui/controls/NumberField";
import { useProblems } from "#ui/controls/problems";
import { fieldName, formulaTyped, typedAs } from "#ui/controls/typed";
import equationsCss from "#ui/shapes/equations.module.css";
import type { MapRow } from "#wasm/api";
import { type ExactRow, exactEntry, exactParts, shownExact } from "./exact-fields";
import mapsCss from "./maps.module.css";
import * as messages from "./messages";

interface MapFieldsProps {
  map: MapRow;
  /** All maps of the shape: what differs among them is seen to differ. */
  among?: readonly MapRow[];
  /** Formulas that entries of these maps mean. */
  exact?: readonly string[];
  /**
   * Takes the map, or says why it cannot be. `field` names what was changed, so that a run of steps is one undo;
   * `exact`: what some of its entries mean from now on.
   */
  onChange: (map: MapRow, field: string, exact?: readonly string[]) => string | undefined;
  onDone: () => void;
}

const PARTS: readonly { key: keyof Parts; label: string; step: number; digits: number; unit?: string }[] = [
  { key: "turn", label: messages.turn, step: 1, digits: 2, unit: "°" },
  { key: "slant", label: messages.slant, step: 0.01, digits: 4 },
  { key: "stretchX", label: messages.stretchAcross, step: 0.01, digits: 4, unit: "×" },
  { key: "stretchY", label: messages.stretchUp, step: 0.01, digits: 4, unit: "×" },
  { key: "moveX", label: messages.moveAcross, step: 0.01, digits: 4 },
  { key: "moveY", label: messages.moveUp, step: 0.01, digits: 4 },
];

const LABELS = Object.fromEntries(PARTS.map(({ key, label }) => [key, label])) as Record<keyof Parts, string>;

/** Turn, stretch and move: how a hand would say it. A negative stretch mirrors. */
export function PartFields({ map, among = [map], onChange, onDone }: MapFieldsProps) {
  const parts = decompose(map);
  const all = among.map(decompose);
  const { tellOf, below } = useProblems();
  const prepared = useRef<ExactRow | null>(null);
  return (
    <>
      <div class={mapsCss["map-fields"]}>
        {PARTS.map(({ key, label, step, digits, unit }) => (
          <NumberField
            key={key}
            label={label}
            value={parts[key]}
            step={step}
            digits={digitsApart(
              all.map((one) => one[key]),
              digits,
            )}
            {...(unit === undefined ? {} : { unit })}
            prepare={(text, value) => {
              const found = exactParts({ ...parts, [key]: value }, (other) =>
                other === key ? formulaTyped(text) : typedAs(fieldName(LABELS[other]), parts[other]),
              );
              return (
                found?.then((row) => {
                  prepared.current = row;
                }) ?? null
              );
            }}
            onChange={(value) => {
              const found = prepared.current;
              prepared.current = null;
              return found
                ? onChange(found.row, key, found.exact)
                : onChange(compose({ ...parts, [key]: value }), key);
            }}
            onDone={onDone}
            problems={tellOf(key)}
          />
        ))}
      </div>
      {below}
    </>
  );
}

const ROWS = [
  {
    axis: "x′",
    cells: [
      [0, "a", messages.newXFromX],
      [1, "b", messages.newXFromY],
      [4, "e", messages.moveAcross],
    ],
  },
  {
    axis: "y′",
    cells: [
      [2, "c", messages.newYFromX],
      [3, "d", messages.newYFromY],
      [5, "f", messages.moveUp],
    ],
  },
] as const;

/** The six numbers, laid out as the two equations that they are. */
export function NumberFields({ map, among = [map], exact = [], onChange, onDone }: MapFieldsProps) {
  const { tellOf, below } = useProblems();
  const prepared = useRef<{ value: number; formula: string } | null>(null);
  formulasRead.value;
  return (
    <>
      <div class={equationsCss["equations"]}>
        {ROWS.map(({ axis, cells }) => (
          <div key={axis} class={equationsCss["equation"]}>
            <span class={equationsCss["equation-axis"]} aria-hidden="true">
              {axis} =
            </span>
            {cells.map(([index, symbol, label]) => (
              <NumberField
                key={symbol}
                terse
                label={`${label}, ${symbol}`}
                symbol={
                  symbol === "e" || symbol === "f"
                    ? symbol
                    : `${symbol} ${symbol === "a" || symbol === "c" ? "x" : "y"}`
                }
                value={map[index]}
                digits={digitsApart(
                  among.map((one) => one[index]),
                  5,
                )}
                formula={shownExact(formulaAt(map[index], exact))}
                prepare={(text, value) =>
                  formulaTyped(text) === undefined
                    ? null
                    : exactEntry(text, value).then((one) => {
                        prepared.current = one;
                      })
                }
                onChange={(value) => {
                  const found = prepared.current;
                  prepared.current = null;
                  const next: MapRow = [...map];
                  next[index] = found?.value ?? value;
                  return onChange(next, symbol, found ? [found.formula] : []);
                }}
                onDone={onDone}
                problems={tellOf(symbol)}
              />
            ))}
          </div>
        ))}
      </div>
      {below}
    </>
  );
}
