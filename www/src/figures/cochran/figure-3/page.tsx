import { useMemo } from "preact/hooks";
import { fixed } from "#format/numbers";
import { toWord } from "#tools/fit/plane/model/curve";
import { EXAMPLES } from "#tools/fit/plane/model/examples";
import { Button } from "#ui/controls/Button";
import { Switch } from "#ui/controls/Switch";
import { Choice, SliderControl } from "../../kit/frame/control";
import { Formula } from "../../kit/frame/formula";
import { Frame, type Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { fitHref } from "../../kit/frame/studio-link";
import { tex } from "../../kit/notation/tex";
import { flag, number, oneOf, parts, whole } from "../../kit/state/fields";
import { kept, useKept } from "../../kit/state/kept";
import { arrowhead, PIECES } from "../graphs/arrowhead";
import { PlaneMapTable } from "../graphs/plane-map-table";
import css from "./page.module.css";
import { type Eye, FROM_CORNER, SpaceView, STEEPEST } from "./space-curve";

const VIEWS: readonly { name: string; about: string; eye: Eye }[] = [
  { name: "From above", about: "t and x: the function of Figure 4", eye: { turn: 0, tilt: 90 } },
  { name: "From the front", about: "t and y: its companion", eye: { turn: 0, tilt: 0 } },
  { name: "From the side", about: "x and y: the gasket", eye: { turn: -90, tilt: 0 } },
  { name: "From the corner", about: "all three at once", eye: FROM_CORNER },
];
/** The gasket that is seen from the side, as a curve of the plane. */
const SIDE = toWord(EXAMPLES.find(({ id }) => id === "arrowhead")?.make() ?? { points: [], pieces: [] });
const MOST_DEPTH = 7;
/** Which of its pieces is shown alone, and what its map does. */
const PIECE_CHOICES = [
  { value: "all", label: "all" },
  { value: "1", label: "P₁" },
  { value: "2", label: "P₂" },
  { value: "3", label: "P₃" },
] as const;
type Shown = (typeof PIECE_CHOICES)[number]["value"];
const ABOUT: Readonly<Record<Shown, string>> = {
  all: "Each third of t is the whole curve, mapped.",
  "1": "P₁: the whole at half size, mirrored and turned. It mixes x with y.",
  "2": "P₂: the whole at half size and no more, so that x and y stay apart.",
  "3": "P₃: the whole at half size, mirrored and turned the other way. It mixes x with y.",
};

/** What stands in its address. */
export const STATE = {
  eye: kept<Eye>(FROM_CORNER, parts({ turn: number(-180, 180, 1), tilt: number(-STEEPEST, STEEPEST, 1) })),
  levels: kept(6, whole(1, MOST_DEPTH)),
  shadows: kept(true, flag),
  piece: kept<Shown>("all", oneOf(PIECE_CHOICES.map(({ value }) => value))),
};

/** The Sierpinski space curve and its three projections. */
export function Page(heading: Heading) {
  const [eye, setEye] = useKept("eye", ...STATE.eye);
  const [depth, setDepth] = useKept("levels", ...STATE.levels);
  const [shadows, setShadows] = useKept("shadows", ...STATE.shadows);
  const [piece, setPiece] = useKept("piece", ...STATE.piece);
  const alone = piece === "all" ? null : Number(piece) - 1;
  const points = useMemo(() => arrowhead(depth), [depth]);
  const pieces = points.length - 1;
  const view = VIEWS.find((one) => one.eye.turn === eye.turn && one.eye.tilt === eye.tilt);
  return (
    <Frame
      {...heading}
      lead={
        <p>
          A curve runs through a Sierpinski gasket from corner to corner, while <Formula>t</Formula> carries
          it forward, and each third of it is a copy of the whole. From the side you see the gasket, since
          nothing of the way forward shows. From above you see a function of t that looks rough in a way no
          formula of Figure 1 gives: part of what its copies need is hidden in the height. Drag to turn it.
        </p>
      }
      found={
        <p>
          Three maps of space make all of it. The middle one only shrinks, so the middle of each shadow is a
          copy of that shadow. The outer two also mirror and turn the gasket: they mix x with y, and a shadow
          that has lost y cannot copy itself there. That is what “hidden variable” means, and Figure 4 shows
          what it does to the graph.
        </p>
      }
      parameters={[
        { name: "Curve", value: "arrowhead through the gasket, t at even steps" },
        {
          name: "Corners",
          symbol: tex`(x, y)`,
          value: [tex`(0, 0),`, tex`(\frac{1}{2}, \frac{1}{2}\sqrt{3}),`, tex`(1, 0)`],
        },
        { name: "Pieces drawn", symbol: tex`3^${depth}`, value: String(pieces) },
        { name: "Seen from", value: `${fixed(eye.turn, 0)}° round, ${fixed(eye.tilt, 0)}° up` },
      ]}
      studio={{
        href: fitHref({ mode: "plane", plane: SIDE }),
        label: "Open its side view in the Fit tool",
      }}
      captions={["Figure 3: A 3-D Sierpinski space curve and its projections onto three coordinate planes."]}
      reconstructed="The maps of this curve are not printed. The arrowhead curve stands for it: with corners at heights 0, ½ and 1 the printed maps of Table 3 come about as near to its top projection as the paper says. The height of the box is the gasket’s own."
    >
      <SpaceView
        points={points}
        eye={eye}
        shadows={shadows}
        piece={alone}
        onTurn={setEye}
        label={`The space curve of ${pieces} pieces, seen from ${fixed(eye.turn, 0)} degrees round and ${fixed(eye.tilt, 0)} degrees up${view ? `: ${view.about}` : ""}${alone === null ? "" : `; piece ${piece} is set apart`}`}
      />
      <fieldset class={layout["buttons"]}>
        <legend class="unseen">Where from</legend>
        {VIEWS.map(({ name, about, eye: there }) => (
          <Button key={name} description={about} pressed={view?.name === name} onClick={() => setEye(there)}>
            {name}
          </Button>
        ))}
        <p class={css["view-about"]} role="status">
          {view?.about ?? ""}
        </p>
      </fieldset>
      <div class={layout["controls"]}>
        <SliderControl
          label="turn"
          range={[-180, 180]}
          step={5}
          value={eye.turn}
          text={`${fixed(eye.turn, 0)}°`}
          valueText={`${fixed(eye.turn, 0)} degrees`}
          onChange={(turn) => setEye({ ...eye, turn })}
        />
        <SliderControl
          label="tilt"
          range={[-STEEPEST, STEEPEST]}
          step={5}
          value={eye.tilt}
          text={`${fixed(eye.tilt, 0)}°`}
          valueText={`${fixed(eye.tilt, 0)} degrees`}
          onChange={(tilt) => setEye({ ...eye, tilt })}
        />
        <SliderControl
          label="pieces"
          name="Levels"
          symbol={tex`3^${depth}`}
          range={[1, MOST_DEPTH]}
          whole
          value={depth}
          text={String(pieces)}
          valueText={`${pieces} pieces`}
          onChange={setDepth}
        />
        <Choice
          label="piece"
          name="Which piece is set apart"
          value={piece}
          options={PIECE_CHOICES}
          onChange={setPiece}
        />
        <Switch checked={shadows} onChange={setShadows}>
          Shadows on the walls
        </Switch>
      </div>
      <p class={layout["hint"]} role="status">
        {ABOUT[piece]}
      </p>
      <PlaneMapTable caption="Its three maps (eq 9)" maps={PIECES} chosen={alone} />
    </Frame>
  );
}
