import { useMemo } from "preact/hooks";
import { fixed } from "#format/numbers";
import { UNIT } from "#geometry/boxes";
import { boxOfPoints } from "#geometry/point-box";
import { Button } from "#ui/controls/Button";
import { Switch } from "#ui/controls/Switch";
import { Problem } from "#ui/panel/Problem";
import { numbersPerMap } from "#workers/fit/map-numbers";
import { Frame, type Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { Panel } from "../../kit/frame/panel";
import { fitHref } from "../../kit/frame/studio-link";
import { Table } from "../../kit/frame/table";
import { flag, whole } from "../../kit/state/fields";
import { kept, useKept } from "../../kit/state/kept";
import { FEATURES, MAPS, useCollages } from "../figure-7/leaf-fits";
import { CollagePanel } from "../figure-7/leaf-panels";
import { OutlineView } from "../figure-7/outline-view";
import { BitmapView } from "./bitmap-view";
import { PRINTED } from "./boundary";
import css from "./page.module.css";
import { useTracedLeaf } from "./traced-leaf";

const MOST_SEED = 9999;

/** What stands in its address. */
export const STATE = {
  seed: kept(1, whole(1, MOST_SEED)),
  tied: kept(false, flag),
};

const count = (n: number) => n.toLocaleString("en");

/** Section 4.3: from pixels to a few maps, each step seen. */
export function Page(heading: Heading) {
  const [seed, setSeed] = useKept("seed", ...STATE.seed);
  const [tied, setTied] = useKept("tied", ...STATE.tied);
  const { steps, problem } = useTracedLeaf(seed);
  const leaf = steps?.leaf ?? null;
  const collages = useCollages(leaf, tied, false);
  const box = useMemo(() => boxOfPoints(leaf?.points ?? []) ?? UNIT, [leaf]);
  const pixels = steps ? `${count(steps.bitmap.width)} × ${count(steps.bitmap.height)} pixels` : "…";
  return (
    <Frame
      {...heading}
      lead={
        <p>
          A scanner gives pixels, and a formula is wanted. The paper goes there in steps: it follows the
          boundary of a leaf, keeps {FEATURES} points of it by splitting a polyline where it misses most, and
          writes each stretch of them as a copy of a longer one. Here is every step, on a leaf that the
          program grows, draws as a bitmap, and then knows nothing else of.
        </p>
      }
      found={
        <p>
          {steps
            ? `Tracing turns ${count(steps.count)} pixels into ${count(steps.traced)} corners between pixels, and ${FEATURES} of these are kept. `
            : "The leaf is being traced … "}
          {collages
            ? `The 52 maps miss the outline by ${fixed(collages[0]?.figures.rms ?? 0)}% of its diagonal, the 29 by ${fixed(collages[1]?.figures.rms ?? 0)}% (root mean square).`
            : "The maps are being fitted …"}{" "}
          The fits are made to the {FEATURES} points, and know nothing of what lies between them.
        </p>
      }
      parameters={[
        { name: "Leaf (reconstructed)", value: `a sugar maple’s, grown by program, seed ${seed}` },
        { name: "Bitmap (reconstructed)", value: pixels },
        {
          name: "Pixels on the boundary",
          value: steps ? `${count(steps.count)}; in the paper ${count(PRINTED)}` : "…",
        },
        { name: "Corners of the traced line", value: steps ? count(steps.traced) : "…" },
        { name: "Feature points", value: `${FEATURES}, as printed, by polyline splitting` },
        { name: "Maps", value: "52 and 29, as printed: non-separable RFIF (eq 9)" },
        { name: "Ranges (reconstructed)", value: "5 intervals each with 52 maps, 9 with 29" },
        { name: "A map costs", value: `${numbersPerMap(false)} numbers` },
      ]}
      captions={[
        "4.3 Approximation of a Leaf Boundary",
        "Figure 7: Maple leaf (top) and FIF approximations with 52 control vertices (left) and 29 control vertices (right).",
      ]}
      reconstructed={`The numbers of the paper’s leaf are not printed: this is another maple leaf, grown by program, and drawn so large that its boundary has about as many pixels. ${count(PRINTED)}, ${FEATURES}, 52 and 29 are printed; the size of the bitmap and the lengths of ranges and domains are not.`}
      differs="The outline is traced between pixels, where the paper counts the pixels themselves."
      studio={{
        href: fitHref({ mode: "outline", model: "collage", numbers: 520 }),
        label: "Open the Fit tool",
      }}
    >
      <div class={layout["controls"]}>
        <Switch checked={tied} onChange={setTied}>
          Tie the ends of copies
        </Switch>
        <Button icon="reset" onClick={() => setSeed((seed % MOST_SEED) + 1)}>
          Grow another leaf
        </Button>
      </div>
      <Problem words={problem} />
      <ol class={css["steps"]}>
        <li>
          <Panel
            name="1. A bitmap"
            words={pixels}
            caption={steps ? `${count(steps.count)} pixels on its boundary` : "growing …"}
          >
            <BitmapView bitmap={steps?.bitmap ?? null} label={`The leaf as a bitmap of ${pixels}`} />
          </Panel>
        </li>
        <li>
          <Panel
            name="2. Its boundary"
            words="traced"
            caption={steps ? `${count(steps.traced)} corners between pixels` : "tracing …"}
          >
            <OutlineView
              box={box}
              label="The line round the leaf, as it was traced"
              lines={leaf ? [{ points: leaf.points, colour: "ink", width: 1, closed: true }] : []}
            />
          </Panel>
        </li>
        <li>
          <Panel
            name={`3. ${FEATURES} points`}
            words="of it"
            caption="where a polyline misses most, again and again"
          >
            <OutlineView
              box={box}
              label={`The polygon of the ${FEATURES} feature points`}
              lines={
                leaf
                  ? [
                      { points: leaf.features, colour: "ink", width: 1, closed: true },
                      { points: leaf.features, colour: 5, dots: 4 },
                    ]
                  : []
              }
            />
          </Panel>
        </li>
        {MAPS.map((maps, i) => (
          <li key={maps}>
            <h2 class={layout["side-name"]}>{i + 4}. A fit</h2>
            <CollagePanel
              maps={maps}
              collage={collages?.[i] ?? null}
              leaf={leaf?.points ?? null}
              box={box}
              tied={tied}
              separable={false}
            />
          </li>
        ))}
        <li>
          <Table caption="What each step takes, in numbers" columns={["Step", "Numbers"]}>
            <tbody>
              {[
                ["Boundary pixels", steps ? 2 * steps.count : null],
                ["Traced corners", steps ? 2 * steps.traced : null],
                ["Feature points", 2 * FEATURES],
                ...MAPS.map((maps): [string, number] => [`${maps} maps`, numbersPerMap(false) * maps]),
              ].map(([name, numbers]) => (
                <tr key={name}>
                  <th scope="row">{name}</th>
                  <td>{numbers === null ? "…" : count(Number(numbers))}</td>
                </tr>
              ))}
            </tbody>
          </Table>
        </li>
      </ol>
    </Frame>
  );
}
