import { type ExactNumber, formulaAt, formulasRead } from "#document/editing/exact";
import { digitsApart, plainNumber } from "#format/numbers";
import { compose, decompose, type Parts } from "#geometry/maps/affine2";
import { NumberField } from "#ui/controls/NumberField";
import { useProblems } from "#ui/controls/problems";
import { fieldName, typedAs } from "#ui/controls/typed";
import equationsCss from "#ui/shapes/equations.module.css";
import type { MapRow } from "#wasm/api";
import { exactEntry, exactParts, type LinearPart, shownExact } from "./exact-fields";
import mapsCss from "./maps.module.css";
import * as messages from "./messages";

interface MapFieldsProps {
  map: MapRow;
  /** All maps of the shape: what differs among them is seen to differ. */
  among?: readonly MapRow[];
  /** Formulas that entries of these maps mean. Without it, numbers are what their digits say. */
  exact?: readonly string[];
  /**
   * Takes the map, and what some of its entries mean from now on, or says why it cannot be. `field` names what was
   * changed, so that a run of steps is one undo.
   */
  onChange: (map: MapRow, exact: readonly string[], field: string) => string | undefined;
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

/** Parts that are entries themselves. */
const MOVES: Partial<Record<keyof Parts, 4 | 5>> = { moveX: 4, moveY: 5 };
const LINEAR = [0, 1, 2, 3] as const;

/** Turn, stretch and move: how a hand would say it. A negative stretch mirrors. */
export function PartFields({ map, among = [map], exact = [], onChange, onDone }: MapFieldsProps) {
  const parts = decompose(map);
  const all = among.map(decompose);
  const { tellOf, below } = useProblems();
  formulasRead.value;
  // What was typed into the other fields holds while it is what the entries mean.
  const isMeant = LINEAR.some((entry) => formulaAt(map[entry], exact) !== undefined);
  return (
    <>
      <div class={mapsCss["map-fields"]}>
        {PARTS.map(({ key, label, step, digits, unit }) => {
          const entry = MOVES[key];
          const typed = (other: keyof Parts) =>
            isMeant ? typedAs(fieldName(LABELS[other]), parts[other]) : undefined;
          return (
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
              {...(entry === undefined
                ? isMeant
                  ? {}
                  : { formula: null }
                : { formula: shownExact(formulaAt(map[entry], exact)) ?? null })}
              prepare={(text, value) =>
                entry === undefined
                  ? exactParts({ ...parts, [key]: value }, (other) =>
                      other === key ? formulaIn(text) : typed(other),
                    )
                  : formulaIn(text) === undefined
                    ? null
                    : exactEntry(text, value)
              }
              onChange={(value, prepared) => {
                if (entry !== undefined) return onChange(...withEntry(map, entry, value, prepared), key);
                const found = prepared as LinearPart | undefined;
                const [a, b, c, d] = found?.linear ?? compose({ ...parts, [key]: value });
                return onChange([a, b, c, d, map[4], map[5]], found?.exact ?? [], key);
              }}
              onDone={onDone}
              problems={tellOf(key)}
            />
          );
        })}
      </div>
      {below}
    </>
  );
}

/** A text that is more than a plain number. */
const formulaIn = (text: string) => (plainNumber(text) === null ? text : undefined);

/** A map with another entry, which may mean a formula. */
function withEntry(map: MapRow, entry: number, value: number, prepared: unknown): [MapRow, string[]] {
  const found = prepared as ExactNumber | undefined;
  const next: MapRow = [...map];
  next[entry] = found?.value ?? value;
  return [next, found ? [found.formula] : []];
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
export function NumberFields({ map, among = [map], exact, onChange, onDone }: MapFieldsProps) {
  const { tellOf, below } = useProblems();
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
                {...(exact ? { formula: shownExact(formulaAt(map[index], exact)) ?? null } : {})}
                prepare={
                  exact && ((text, value) => (formulaIn(text) === undefined ? null : exactEntry(text, value)))
                }
                onChange={(value, prepared) => onChange(...withEntry(map, index, value, prepared), symbol)}
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
