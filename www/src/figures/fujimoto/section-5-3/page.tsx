import { useMemo } from "preact/hooks";
import { fixed } from "#format/numbers";
import { asExample, atRest, EXAMPLES } from "#tools/space/bend/bend-edits";
import { Button } from "#ui/controls/Button";
import type { MapRow3, Point3, SpaceBend, SpaceShown } from "#wasm/api";
import { loadSpace, solid } from "#wasm/space";
import { VIEW } from "../../darwish/space/eye";
import { SpacePicture } from "../../darwish/space/space-picture";
import { inSpaceTool, presetMaps } from "../../darwish/space/tool-link";
import { Choice, SliderControl } from "../../kit/frame/control";
import { Formula } from "../../kit/frame/formula";
import { Frame, type Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { Panel } from "../../kit/frame/panel";
import { tex } from "../../kit/notation/tex";
import { flag, number, oneOf } from "../../kit/state/fields";
import { kept, useKept } from "../../kit/state/kept";
import { HOME, IDENTITY, SHAPES, type ShapeName } from "./shapes";

const IDS = EXAMPLES.map(({ id }) => id);

/** What stands in its address. */
export const STATE = {
  shape: kept<ShapeName>("sponge", oneOf(SHAPES.map(({ value }) => value))),
  pull: kept<string>("corner", oneOf(IDS)),
  amount: kept(1, number(0, 1, 2)),
  kb: kept(0, number(0, 4, 1)),
  delta: kept(0.8, number(0, 1.5, 2)),
  ke: kept(3, number(0, 4, 1)),
  turned: kept(false, flag),
  view: kept(HOME, VIEW),
};

/** What must be there before it is shown. */
export const needs = [loadSpace];

const shown = (maps: MapRow3[], bend: SpaceBend): SpaceShown[] => [
  { maps, bent: { maps, moved: IDENTITY, bend } },
];

/** Section 5.3 in space: a lattice of control points around the sponge, and every part answers. */
export function Page(heading: Heading) {
  const [shape, setShape] = useKept("shape", ...STATE.shape);
  const [pull, setPull] = useKept("pull", ...STATE.pull);
  const [amount, setAmount] = useKept("amount", ...STATE.amount);
  const [kb, setKb] = useKept("kb", ...STATE.kb);
  const [delta, setDelta] = useKept("delta", ...STATE.delta);
  const [ke, setKe] = useKept("ke", ...STATE.ke);
  const [turned, setTurned] = useKept("turned", ...STATE.turned);
  const [view, setView] = useKept("view", ...STATE.view);
  const maps = useMemo(() => presetMaps(shape), [shape]);
  const room = useMemo(() => solid.bendRoom3(maps), [maps]);
  const least = Math.min(kb, ke);
  const bend = useMemo((): SpaceBend => {
    const example = EXAMPLES.find(({ id }) => id === pull) ?? EXAMPLES[0];
    const rest = {
      ...atRest([3, 3, 3], ke),
      kb: least,
      delta,
      spin: turned ? "orthogonal" : "none",
    } as const;
    if (!example) return rest;
    const sides = room.max.map((x, k) => x - (room.min[k] ?? 0));
    const longest = Math.max(...sides);
    const moved = asExample(rest, example, sides.map((side) => side / longest) as Point3);
    return { ...moved, moves: moved.moves.map((by) => by.map((x) => x * amount) as Point3) };
  }, [pull, amount, least, delta, ke, turned, room]);
  const fractal = useMemo(() => shown(maps, bend), [maps, bend]);
  const plain = useMemo(() => shown(maps, { ...bend, kb: ke }), [maps, bend, ke]);
  const { label } = SHAPES.find(({ value }) => value === shape) ?? { label: shape };
  const about = EXAMPLES.find(({ id }) => id === pull)?.label.toLowerCase() ?? pull;
  return (
    <Frame
      {...heading}
      lead={
        <p>
          “Arbitrary dimension can be treated”, the paper says, and shows the plane alone. Here is space: a
          lattice of 3 × 3 × 3 control points around a shape, one pull, and every piece at every scale answers
          in its own place. On the left the lattice bends the shape as it would rubber (eq 16), on the right
          as eq 18 has it. Turn both by hand.
        </p>
      }
      found={
        <>
          <p>
            The pieces of these shapes meet in corners. Each term is sampled at the corners of its own cells,
            averaged where cells share one, and interpolated inside: in a tetrahedron by barycentric
            coordinates, in a cube trilinearly. So nothing tears, at any <Formula tex={tex`k_b`} />. The
            picture is complete: for each piece there is a ball that holds all of it, bent, and what is larger
            than a pixel is looked into.
          </p>
          <p>
            <strong>Connected-IST.</strong> The paper wants to extend them next, and defines them elsewhere.
            What would a shuffle need on a shape that is put together of several? If it is put together of
            units with codes of their own, the letter that names the unit has to stay: reversed, it would
            stand where a letter of the unit is due. Then it is the shuffle of this page with one letter more
            to stay, and corners that two units share are averaged like all others. If the parts are of
            several kinds, each made of the others (a graph-directed system), a word read backwards is a code
            again only where there is one kind: tried on all such graphs with two kinds and up to two arrows
            from each to each. With as many arrows from every kind, their numbers can be shuffled, but a
            shuffled word then ends in a part of another kind, and its tail with it. And no order of the
            letters but the given one is continuous on a gasket by itself: the middle of an edge has two
            codes, <Formula tex={tex`abbb\ldots`} /> and <Formula tex={tex`baaa\ldots`} />, and goes to two
            places as soon as the first letter moves. So it is the repair at the corners that connects, not
            the shuffle.
          </p>
        </>
      }
      parameters={[
        { name: "Shape", value: `${label}, ${maps.length} maps` },
        { name: "Control points", value: "3 × 3 × 3 over the box around the shape, Bézier of degree 2" },
        { name: "Locality", symbol: tex`k_b`, value: fixed(least, 1) },
        { name: "Detail", symbol: tex`k_e`, value: fixed(ke, 1) },
        { name: "Roughness", symbol: "δ", value: fixed(delta) },
        { name: "Rotation", value: turned ? "by the maps from kb + 1 on" : "none" },
      ]}
      captions={["5.3 Fractal Deformation Based on Ext-unit-IST"]}
      own
      reconstructed="The paper has no figure of space. Its formulas (eqs 12, 13, 16, 18, 19) hold in any dimension; the lattice, its degree and the pulls are made here."
      differs="What keeps the pieces together is not the paper’s averages over a Delaunay triangulation, but corners that cells share."
      studio={inSpaceTool([{ preset: shape, name: label, maps, bend }], view)}
    >
      <div class={layout["buttons"]}>
        <Choice label="Shape" value={shape} options={SHAPES} onChange={setShape} />
        <Choice
          label="Pull"
          value={pull}
          options={EXAMPLES.map(({ id, label }) => ({ value: id, label }))}
          onChange={setPull}
        />
        <Choice
          label="Pieces"
          name="Whether displacements turn with the pieces"
          value={turned ? "turn" : "keep"}
          options={[
            { value: "keep", label: "keep the direction" },
            { value: "turn", label: "turn it" },
          ]}
          onChange={(next) => setTurned(next === "turn")}
        />
        <Button kind="quiet" icon="reset" disabled={view === HOME} onClick={() => setView(HOME)}>
          As at first
        </Button>
      </div>
      <div class={`${layout["two-columns"]} ${layout["even"]}`}>
        <Panel name="A" words="plain: the lattice as rubber">
          <SpacePicture
            objects={plain}
            view={view}
            onView={setView}
            label={`${label}, ${about}, bent as a whole`}
          />
        </Panel>
        <Panel name="B" words="fractal: every piece answers">
          <SpacePicture
            objects={fractal}
            view={view}
            onView={setView}
            label={`${label}, ${about}, bent at every scale: locality ${fixed(least, 1)}, roughness ${fixed(delta)}, detail ${fixed(ke, 1)}`}
          />
        </Panel>
      </div>
      <div class={layout["controls"]}>
        <SliderControl label="pulled" range={[0, 1]} value={amount} onChange={setAmount} />
        <SliderControl label="locality" symbol={tex`k_b`} range={[0, 4]} value={least} onChange={setKb} />
        <SliderControl label="roughness" symbol="δ" range={[0, 1.5]} value={delta} onChange={setDelta} />
        <SliderControl label="detail" symbol={tex`k_e`} range={[0, 4]} value={ke} onChange={setKe} />
      </div>
    </Frame>
  );
}
