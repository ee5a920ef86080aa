import { fitDocument, type Use } from "#document/fit";
import { Button } from "#ui/controls/Button";
import fitCss from "../fit.module.css";
import { croppedPhotograph, photographed } from "../kept/photograph";
import { saveCsv, saveJson, savePng, saveSvg } from "../save";
import { cutting } from "../stage/layers";
import { bendPhotograph, fernFit, shownShape, use, waiting } from "../use";
import { shownFigures, shownFit } from "../work/fitting";
import { changeMask } from "../work/mask";
import { plainName } from "../work/name";
import { running } from "../work/progress";
import { source } from "../work/source";
import { stalk } from "../work/stalked";
import { shownWithin, withinDone } from "../work/within";

/** Only what waits can be taken back. */
const heldFor = (to: Use) => (waiting.value === to ? { pressed: true } : {});

/** Where the fit goes from here. */
export function UsePanel() {
  if (cutting.value) return null;
  const { model } = fitDocument.value;
  const spline = model === "spline";
  const closed = spline || model === "closed";
  const fitted = spline ? shownWithin.value : shownFit.value;
  const ready = closed ? fitted !== null : shownFigures.value !== null;
  return (
    <section class="stack" aria-label="Use it">
      <div class="section-head">
        <h2>Use it</h2>
      </div>
      <div class={fitCss["source-buttons"]}>
        <Button kind="primary" icon="arrow" disabled={!ready} {...heldFor("a")} onClick={() => use("a")}>
          Use as A
        </Button>
        <Button
          disabled={!ready}
          {...heldFor("b")}
          description="The last shape of the morph, instead of the first"
          onClick={() => use("b")}
        >
          Use as B
        </Button>
        <Button disabled={!ready} {...heldFor("bent")} onClick={() => use("bent")}>
          Bend it
        </Button>
        {closed && (
          <Button
            disabled={!ready}
            description="A fern becomes this outline, edge by edge and in one piece all the way"
            onClick={fernFit}
          >
            From a fern
          </Button>
        )}
        {closed && photographed.value && (
          <Button
            disabled={!ready}
            description="The leaf, cut out along the curve, under the grid"
            onClick={() => {
              const shape = shownShape();
              if (shape) void bendPhotograph(plainName(source.peek().name), shape.curve, croppedPhotograph());
            }}
          >
            Bend its photograph
          </Button>
        )}
      </div>
      {stalk.value > 0 && (
        <div class="notes stack">
          <p>
            It has a stalk, {Math.round(100 * stalk.value)}% as long as the whole. Between a leaf with a stalk
            and one without, few knots may find a partner, and the way may cross itself.
          </p>
          <Button onClick={() => changeMask((now) => ({ ...now, stalk: "remove" }))}>
            Take off the stalk
          </Button>
        </div>
      )}
      {spline && (withinDone.value?.bends ?? 0) > 0 && (
        <p class="hint">
          Morphs and bends take corners alone: there its parabolas are straight sides, too short to be seen.
        </p>
      )}
      {!closed && <p class="hint">The closed curve is what is morphed and bent: it has no gaps.</p>}
      <div class="row">
        <span class="row-name">Save as</span>
        <span class={fitCss["save-buttons"]}>
          {(
            [
              ["SVG", saveSvg],
              ["CSV", saveCsv],
              ["JSON", saveJson],
              ["PNG", savePng],
            ] as const
          ).map(([name, save]) => (
            <Button key={name} disabled={!ready && closed} description={`Save as ${name}`} onClick={save}>
              {name}
            </Button>
          ))}
        </span>
      </div>
      {running.value && closed && (
        <p class="hint" role="status">
          {waiting.value === null
            ? "It still improves: it is taken there when it is done."
            : "It goes there as soon as it is done. Press again to stay; Cancel takes the best so far."}
        </p>
      )}
    </section>
  );
}
