import { fitDocument } from "#document/fit";
import { Button } from "#ui/controls/Button";
import fitCss from "../fit.module.css";
import { saveCsv, saveJson, savePng, saveSvg } from "../save";
import { cutting } from "../stage/layers";
import { use } from "../use";
import { running, shownFigures, shownFit } from "../work/fitting";

/** Where the fit goes from here. */
export function UsePanel() {
  if (cutting.value) return null;
  const closed = fitDocument.value.model === "closed";
  const ready = closed ? shownFit.value !== null : shownFigures.value !== null;
  return (
    <section class="stack" aria-label="Use it">
      <div class="section-head">
        <h2>Use it</h2>
      </div>
      <div class={fitCss["source-buttons"]}>
        <Button kind="primary" icon="arrow" disabled={!ready} onClick={() => use("morph")}>
          Use in the morph
        </Button>
        <Button disabled={!ready} onClick={() => use("deform")}>
          Bend it
        </Button>
      </div>
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
      {running.value && closed && <p class="hint">It still improves: what is taken is the best so far.</p>}
    </section>
  );
}
