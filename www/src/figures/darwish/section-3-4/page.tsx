import { useMemo, useRef } from "preact/hooks";
import { boxOf } from "#document/framing";
import { fixed } from "#format/numbers";
import { union } from "#geometry/boxes";
import { apartBy, apartWords } from "#geometry/maps/apart";
import { isBroken } from "#geometry/states";
import { Button } from "#ui/controls/Button";
import { MapBlocks } from "#ui/shapes/MapBlocks";
import type { MapRow } from "#wasm/api";
import { frond } from "#wasm/core";
import { Choice, SliderControl } from "../../kit/frame/control";
import { Formula } from "../../kit/frame/formula";
import { Frame, type Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { Panel } from "../../kit/frame/panel";
import { preset, studioHref } from "../../kit/frame/studio-link";
import { VerdictChip } from "../../kit/frame/verdict";
import { Square } from "../../kit/locus/locus-square";
import { useChart } from "../../kit/locus/morph-locus";
import { shareWords } from "../../kit/maps/breakage";
import { STRAIGHT } from "../../kit/maps/morphs";
import { tex } from "../../kit/notation/tex";
import { useDrag } from "../../kit/picture/drag";
import { Picture } from "../../kit/picture/picture";
import { useRested } from "../../kit/rest";
import { number, oneOf } from "../../kit/state/fields";
import { kept, useKept } from "../../kit/state/kept";
import { useVerdict } from "../../kit/workers";
import spaceCss from "../space/space.module.css";
import { AT_FIRST, type Moves, NONE, transformOf } from "./moves";
import css from "./page.module.css";

const SHAPES = [
  { value: "gasket", label: "Gasket", to: "dragon-3" },
  { value: "dragon-3", label: "Dragon of three", to: "gasket" },
  { value: "fern", label: "Fern", to: "tree" },
] as const;
type Name = (typeof SHAPES)[number]["value"];

/** What is printed the same is the same here. */
const SEEN = 0.5e-3;
/** Samples a side. */
const SAMPLES = 85;

/** What stands in its address. */
export const STATE = {
  shape: kept<Name>("fern", oneOf(SHAPES.map(({ value }) => value))),
  turn: kept(AT_FIRST.turn, number(-180, 180, 1)),
  size: kept(AT_FIRST.size, number(0.2, 2, 2)),
  slide: kept(AT_FIRST.slide, number(-1.5, 1.5, 2)),
  x: kept(AT_FIRST.x, number(-1, 1, 3)),
  y: kept(AT_FIRST.y, number(-1, 1, 3)),
};

/** A shape of the gallery, and what is moved is measured by. */
function shapeOf(name: Name) {
  const shape = preset(name);
  const box = boxOf(shape.maps) ?? { x0: 0, y0: 0, x1: 1, y1: 1 };
  const unit = Math.max(box.x1 - box.x0, box.y1 - box.y0);
  const middle = [(box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2] as const;
  // Room for what is moved and turned.
  const half = 0.7 * unit;
  const [x, y] = middle;
  return { shape, unit, middle, box: union([{ x0: x - half, y0: y - half, x1: x + half, y1: y + half }]) };
}

/** Section 3.4 in the plane: the transform of a shape, done to its parameters. */
export function Page(heading: Heading) {
  const [name, setName] = useKept("shape", ...STATE.shape);
  const [turn, setTurn] = useKept("turn", ...STATE.turn);
  const [size, setSize] = useKept("size", ...STATE.size);
  const [slide, setSlide] = useKept("slide", ...STATE.slide);
  const [x, setX] = useKept("x", ...STATE.x);
  const [y, setY] = useKept("y", ...STATE.y);
  const { shape, unit, middle, box } = useMemo(() => shapeOf(name), [name]);
  const by = useMemo(
    () => transformOf({ turn, size, slide, x, y }, middle, unit),
    [turn, size, slide, x, y, middle, unit],
  );
  const now = useMemo(() => frond.conjugate({ maps: shape.maps }, by).maps, [shape, by]);
  const set = (moves: Moves) => {
    setTurn(moves.turn);
    setSize(moves.size);
    setSlide(moves.slide);
    setX(moves.x);
    setY(moves.y);
  };
  const within = (at: number) => Math.min(1, Math.max(-1, at));
  const other = useMemo(() => preset(SHAPES.find(({ value }) => value === name)?.to ?? "gasket"), [name]);
  const [a, b, c, d, e, f] = by;
  const told = (entry: number) => fixed(entry, 3);
  return (
    <Frame
      {...heading}
      lead={
        <p>
          A shape is to be turned, scaled, slid or moved, all of which is a transform{" "}
          <Formula tex={tex`T x = A_T x + b_T`} />. No point of it has to be touched: each map{" "}
          <Formula tex={tex`w x = A x + b`} /> becomes <Formula tex={tex`\bar w = T w T^{-1}`} />, and the new
          maps draw the moved shape. Drag it, and watch its parameters.
        </p>
      }
      found={
        <p>
          The verdict is the same wherever the shape is: pieces that meet do so before and after. A proof may
          be lost on the way all the same, as it needs round numbers. The locus is not the same: what a shape
          can become without falling apart hangs on where it lies and how it is turned. In the morph of the
          studio, press Shift+E to take a shape in hand.
        </p>
      }
      parameters={[
        { name: "Shape", value: `${shape.name}, ${shape.maps.length} maps` },
        {
          name: "Transform",
          symbol: "T",
          value: [
            tex`A_T = (${told(a)}, ${told(b)}; ${told(c)}, ${told(d)})`,
            tex`b_T = (${told(e)}, ${told(f)})`,
          ],
        },
        {
          name: "Eq 1",
          value: [tex`\bar A_i = A_T A_i A_T^{-1}`, tex`\bar b_i = A_T b_i + b_T - A_T A_i A_T^{-1} b_T`],
        },
      ]}
      captions={["3.4. Linear Transformations to IFS fractals"]}
      own
      reconstructed="The section has no figure: this one is made here, on shapes of Frond’s gallery."
      differs="The paper proves eq 1 for transforms of any dimension, and shows it in space only. Its matrix of a rotation about z turns clockwise; angles here are counter-clockwise."
      studio={{ href: studioHref({ a: { name: shape.name, maps: now }, b: other }) }}
    >
      <div class={layout["controls"]}>
        <Choice label="Shape" value={name} options={SHAPES} onChange={setName} />
        <div class={layout["buttons"]}>
          <Button kind="quiet" icon="reset" onClick={() => set(NONE)}>
            As made
          </Button>
        </div>
      </div>
      <div class={spaceCss["space-figure"]}>
        <div class={spaceCss["space-hand"]}>
          <Dragged
            maps={now}
            box={box}
            label={`${shape.name}, turned by ${fixed(turn, 0)} degrees, ${fixed(size)} times as large, slid by ${fixed(slide)}`}
            onDrag={(dx, dy) => {
              setX((at) => within(at + dx / unit));
              setY((at) => within(at + dy / unit));
            }}
          />
          <div class={layout["controls"]}>
            <SliderControl
              label="turned"
              range={[-180, 180]}
              whole
              value={turn}
              text={`${fixed(turn, 0)}°`}
              valueText={`${fixed(turn, 0)} degrees`}
              onChange={setTurn}
            />
            <SliderControl label="scaled" range={[0.2, 2]} value={size} onChange={setSize} />
            <SliderControl label="x slides with y" range={[-1.5, 1.5]} value={slide} onChange={setSlide} />
            <SliderControl label="moved along x" range={[-1, 1]} value={x} onChange={setX} />
            <SliderControl label="moved along y" range={[-1, 1]} value={y} onChange={setY} />
          </div>
        </div>
        <Told made={shape.maps} now={now} by={by} />
      </div>
      <Loci
        made={shape.maps}
        now={now}
        other={other.maps}
        about={`on the way to the ${other.name.toLowerCase()}`}
      />
    </Frame>
  );
}

interface DraggedProps {
  maps: MapRow[];
  box: ReturnType<typeof shapeOf>["box"];
  label: string;
  /** In the plane, y up. */
  onDrag: (dx: number, dy: number) => void;
}

/** The picture, which a hand moves; keys have the sliders below it. */
function Dragged({ maps, box, label, onDrag }: DraggedProps) {
  const drag = useDrag((dx, dy) => {
    const height = host.current?.clientHeight ?? 0;
    const width = host.current?.clientWidth ?? 0;
    const scale = Math.min(width / (box.x1 - box.x0), height / (box.y1 - box.y0));
    if (scale > 0) onDrag(dx / scale, -dy / scale);
  });
  const host = useRef<HTMLDivElement>(null);
  return (
    <div ref={host} class={css["dragged"]} {...drag}>
      <Picture maps={maps} box={box} label={label} />
    </div>
  );
}

/** The parameters, how far the two ways are apart, and what is decided of both. */
function Told({ made, now, by }: { made: MapRow[]; now: MapRow[]; by: MapRow }) {
  const apart = useMemo(() => apartBy(made, now, by), [made, now, by]);
  const before = useVerdict(made);
  const after = useVerdict(now);
  return (
    <div class={spaceCss["space-table"]}>
      <h2>Its parameters</h2>
      <MapBlocks
        label="Its parameters now"
        maps={now}
        digits={3}
        mark="not as made"
        marked={(map, place) => Math.abs((now[map]?.[place] ?? 0) - (made[map]?.[place] ?? 0)) > SEEN}
      />
      <p class={spaceCss["space-note"]} role="status">
        <strong>Conjugated parameters, or moved points?</strong> {apartWords(apart)}
      </p>
      <div class={css["verdicts"]}>
        <span>As made</span>
        <VerdictChip answer={before?.answer ?? null} stale={before?.maps !== made} />
        <span>Moved</span>
        <VerdictChip answer={after?.answer ?? null} stale={after?.maps !== now} />
      </div>
    </div>
  );
}

interface LociProps {
  made: MapRow[];
  now: MapRow[];
  other: MapRow[];
  about: string;
}

const LINES = [{ name: "straight", points: STRAIGHT, dashed: true }];

/** Where the morph to another shape holds together: from the shape as made, and from where it is now. */
function Loci({ made, now, other, about }: LociProps) {
  return (
    <div class={`${layout["two-columns"]} ${layout["even"]}`}>
      <Locus from={made} to={other} name="As made" about={about} />
      <Locus from={useRested(now)} to={other} name="Moved" about={about} />
    </div>
  );
}

function Locus({ from, to, name, about }: { from: MapRow[]; to: MapRow[]; name: string; about: string }) {
  const wish = useMemo(() => ({ ends: { from, to }, options: NO_OPTIONS, size: SAMPLES }), [from, to]);
  const field = useChart(wish);
  const holds = useMemo(() => {
    if (field?.progress !== 1) return null;
    return field.state.filter((state) => !isBroken(state)).length / field.state.length;
  }, [field]);
  return (
    <Panel
      name={name}
      words={about}
      caption={holds === null ? "Being filled in …" : `${shareWords(holds)} of the square holds together.`}
    >
      <Square
        field={field}
        label={`Where the shape, ${name.toLowerCase()}, holds together ${about}`}
        lines={LINES}
      />
    </Panel>
  );
}

const NO_OPTIONS = {};
