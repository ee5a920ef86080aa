import { useMemo, useRef } from "preact/hooks";
import { dark } from "#document/preferences";
import { palette } from "#style/palette";
import { Button } from "#ui/controls/Button";
import { NumberField } from "#ui/controls/NumberField";
import { Select } from "#ui/controls/Select";
import { Switch } from "#ui/controls/Switch";
import { Problem } from "#ui/panel/Problem";
import { loadDirected } from "#wasm/directed";
import { SliderControl } from "../../kit/frame/control";
import { Frame, type Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { tex } from "../../kit/notation/tex";
import { pixelRatio, usePixels } from "../../kit/picture/canvas";
import { flag, parts, text } from "../../kit/state/fields";
import { kept, useKept } from "../../kit/state/kept";
import { useValue } from "../../kit/workers";
import { GRIDS, gridOf, shapeOf } from "./grids";
import { Kinds } from "./kinds";
import { boxOf, useMeeting } from "./meeting";
import { openedHref } from "./opened";
import { COLOURS, Overlay } from "./overlay";
import css from "./page.module.css";
import { fraction, held, MOST_OVER, ranges, rescaled, SHIFT, type Shift, shiftWords } from "./shift";
import { WhereItStops } from "./stops";
import { dimensionWords, verdictOf } from "./words";

const ID = text(/[a-z0-9-]{1,20}/);

/** What stands in its address. */
export const STATE = {
  grid: kept("gauss-2", ID),
  first: kept("dragon", ID),
  second: kept("dragon", ID),
  by: kept<Shift>([4, 0, 4], SHIFT),
  shown: kept({ first: true, second: true }, parts({ first: flag, second: flag })),
};

/** What must be there before it is shown. */
export const needs = [loadDirected];

const AXES = [
  { name: "x", place: 0 },
  { name: "y", place: 1 },
] as const;

/** Two shapes of one grid, the second moved by a fraction, and what they share. */
export function Page(heading: Heading) {
  const [gridId, setGrid] = useKept("grid", ...STATE.grid);
  const [firstId, setFirst] = useKept("first", ...STATE.first);
  const [secondId, setSecond] = useKept("second", ...STATE.second);
  const [by, setBy] = useKept("by", ...STATE.by);
  const [shown, setShown] = useKept("shown", ...STATE.shown);
  // An address may name grids and shapes that there are not.
  const grid = gridOf(gridId);
  const [first, second] = [shapeOf(grid, firstId), shapeOf(grid, secondId)];
  const { isLine } = grid;
  const boxes = useMemo(() => [boxOf(first.system), boxOf(second.system)] as const, [first, second]);
  const limits = ranges(...boxes, by[2]);
  const shift = held(by, limits);
  const over = shift[2];
  const frame = useRef<HTMLDivElement>(null);
  const size = usePixels(frame);
  const meeting = useMeeting({ grid, first: first.system, second: second.system, shift, boxes, size });
  const { found, problem, stale } = meeting;
  const verdict = found ? verdictOf(found) : null;
  const colours = palette(useValue(dark) ? "dark" : "light");
  const words = shiftWords([shift[0], shift[1]], over, isLine);
  const move = (dx: number, dy: number) => setBy(held([shift[0] + dx, shift[1] + dy, over], limits));
  const rest = useRef([0, 0]);
  const drag = (dx: number, dy: number) => {
    const steps = [dx, dy].map((d, i) => {
      const whole = (rest.current[i] ?? 0) + (d * pixelRatio() * over) / meeting.scale;
      const step = Math.round(whole);
      rest.current[i] = whole - step;
      return step;
    });
    if (steps.some((step) => step !== 0)) move(steps[0] ?? 0, steps[1] ?? 0);
  };
  const axes = isLine ? AXES.slice(0, 1) : AXES;
  const href = useMemo(() => found && openedHref(found), [found]);
  return (
    <Frame
      {...heading}
      own
      {...(href === null ? {} : { studio: { href, label: "Open what they share" } })}
      lead={
        <p>
          The paper ends by asking whether what two fractals share is a fractal again. Where the pieces of
          both lie on one grid it can be worked out without rounding: however the second is moved by a
          fraction, what they share is made of finitely many kinds of pieces, each of copies of the others.
          Move it, and see which.
        </p>
      }
      found={<WhereItStops />}
      parameters={[
        { name: "What the two share", value: [tex`X_t = A \cap (B + t)`] },
        { name: "Its pieces", value: [tex`X_t = \bigcup_{d, d'} M^{-1}(X_{t'} + d)`] },
        { name: "Left of a shift", value: [tex`t' = M t + d' - d`] },
        { name: "Matrix", symbol: "M", value: matrixWords(first.system.matrix) },
        { name: "Shifts that go on for ever", value: found ? String(found.shifts) : "–" },
        { name: "Kinds of pieces", value: found ? String(found.states.length) : "–" },
        { name: "Dimension", value: found ? dimensionWords(found) : "–" },
        { name: "Each level has more pieces by", value: growth(found?.dimension, grid.scale) },
      ]}
      captions={[
        "The question that still remain[s] is whether the intersection of two fractals could also be represented as a fractal",
      ]}
      reconstructed="The paper asks, in the last sentence of its section 4, and prints no example. That such intersections are graph-directed is known (Bondarenko & Kravchenko 2010 measure them so, and neighbours of tiles are found so); their dimension is that of Mauldin & Williams (1988). Kinds of the same pieces are made one (Moore 1956), and where that is simpler, so are shifts that are met after the same digits (the subset construction, Rabin & Scott 1959)."
    >
      <div class={css["choices"]}>
        <Pick name="Grid" of={GRIDS} value={grid.id} onChange={setGrid} />
        <Pick name="First shape" of={grid.shapes} value={first.id} onChange={setFirst} />
        <Pick name="Second shape" of={grid.shapes} value={second.id} onChange={setSecond} />
        <Button
          icon="swap"
          kind="quiet"
          onClick={() => {
            setFirst(second.id);
            setSecond(first.id);
            setBy([-shift[0] + 0, -shift[1] + 0, over]);
          }}
        >
          Swap
        </Button>
      </div>
      <div class={layout["two-columns"]}>
        <div class="stack">
          <div ref={frame}>
            <Overlay
              layers={meeting.layers}
              shown={shown}
              isLine={isLine}
              label={`${first.name}, and ${second.name}, moved by ${words}. ${verdict?.title ?? ""}`}
              onDrag={drag}
              onStep={move}
            />
          </div>
          <ul class={css["key"]}>
            <li>
              <Swatch colour={colours[COLOURS.first]} />
              <Switch checked={shown.first} onChange={(on) => setShown({ ...shown, first: on })}>
                First{isLine && ", above"}: {first.name}
              </Switch>
            </li>
            <li>
              <Swatch colour={colours[COLOURS.second]} />
              <Switch checked={shown.second} onChange={(on) => setShown({ ...shown, second: on })}>
                Second{isLine && ", below"}: {second.name}
              </Switch>
            </li>
            <li>
              <span class={`${css["swatch"]} ${css["shared"]}`} aria-hidden="true" />
              <span>
                What they share{isLine && ", through both"}
                {meeting.layers.marks.length > 0 && ", ringed"}
              </span>
            </li>
          </ul>
        </div>
        <div class="stack">
          <div class={css["moves"]}>
            {axes.map(({ name, place }) => (
              <SliderControl
                key={name}
                label={isLine ? "Second moved by" : `Second moved along ${name}`}
                range={limits[place] ?? [0, 0]}
                whole
                value={shift[place]}
                text={fraction(shift[place], over)}
                onChange={(p) => setBy(held(place === 0 ? [p, shift[1], over] : [shift[0], p, over], limits))}
              />
            ))}
            <div class={css["numbers"]}>
              {axes.map(({ name, place }) => (
                <NumberField
                  key={name}
                  label={`${name}, so many parts`}
                  symbol={name}
                  terse
                  whole
                  value={shift[place]}
                  min={limits[place]?.[0] ?? 0}
                  max={limits[place]?.[1] ?? 0}
                  onChange={(p) => {
                    if (!Number.isInteger(p)) return "A whole number, please.";
                    setBy(place === 0 ? [p, shift[1], over] : [shift[0], p, over]);
                    return undefined;
                  }}
                />
              ))}
              <NumberField
                label="Parts of a unit"
                symbol="/"
                terse
                whole
                value={over}
                min={1}
                max={MOST_OVER}
                onChange={(next) => {
                  if (!Number.isInteger(next)) return "A whole number, please.";
                  setBy(rescaled(shift, next));
                  return undefined;
                }}
              />
            </div>
          </div>
          <div class={css["verdict"]} role="status">
            <Problem words={problem} />
            {verdict && (
              <>
                <p>
                  <strong>{verdict.title}</strong>
                </p>
                <p>{verdict.text}</p>
                {found && typeof found.addresses === "string" && (
                  <p>
                    Dimension {dimensionWords(found)}
                    {found.isExact
                      ? ", exactly: digits leave different remainders, so that pieces do not overlap."
                      : ", a bound: two digits leave the same remainder, so that pieces may overlap."}
                  </p>
                )}
              </>
            )}
          </div>
        </div>
      </div>
      {found && <Kinds found={found} first={first.system} isLine={isLine} stale={stale} />}
    </Frame>
  );
}

function matrixWords([a, b, c, d]: readonly [number, number, number, number]): string {
  return `rows (${a} ${b}) and (${c} ${d})`.replace(/-/g, "−");
}

/** By which factor the number of pieces grows from level to level. */
function growth(dimension: number | undefined, scale: number): string {
  return dimension === undefined ? "–" : (scale ** dimension).toFixed(4);
}

function Swatch({ colour }: { colour: string | undefined }) {
  return <span class={css["swatch"]} style={{ background: colour }} aria-hidden="true" />;
}

interface PickProps {
  name: string;
  of: readonly { id: string; name: string }[];
  value: string;
  onChange: (id: string) => void;
}

function Pick({ name, of, value, onChange }: PickProps) {
  return (
    <label>
      {name}
      <Select value={value} onChange={(event) => onChange(event.currentTarget.value)}>
        {of.map(({ id, name: words }) => (
          <option key={id} value={id}>
            {words}
          </option>
        ))}
      </Select>
    </label>
  );
}
