import { fitDocument, type Use } from "#document/fit";
import { Button } from "#ui/controls/Button";
import fitCss from "../fit.module.css";
import { croppedPhotograph, photographed } from "../kept/photograph";
import { saveCsv, saveJson, savePng, saveSvg } from "../save";
import { cutting } from "../stage/layers";
import { bendPhotograph, fernFit, shownShape, use, waiting } from "../use";
import { shownFigures, shownFit } from "../work/fitting";
import { changeMask } from "../work/mask";
import { running } from "../work/progress";
import { plainName, source } from "../work/source";
import { stalk } from "../work/stalk";
import { shownWithin, withinDone } from "../work/within";
import * as messages from "./messages";

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
    <section class="stack" aria-label={messages.use}>
      <div class="section-head">
        <h2>{messages.use}</h2>
      </div>
      <div class={fitCss["source-buttons"]}>
        <Button kind="primary" icon="arrow" disabled={!ready} {...heldFor("a")} onClick={() => use("a")}>
          {messages.useAs}
        </Button>
        <Button
          disabled={!ready}
          {...heldFor("b")}
          description={messages.becomesLastShapeMorph}
          onClick={() => use("b")}
        >
          {messages.useAsB}
        </Button>
        <Button disabled={!ready} {...heldFor("bent")} onClick={() => use("bent")}>
          {messages.deform}
        </Button>
        {closed && (
          <Button disabled={!ready} description={messages.fernBecomesThisOutline} onClick={fernFit}>
            {messages.fromFern}
          </Button>
        )}
        {closed && photographed.value && (
          <Button
            disabled={!ready}
            description={messages.leafCutOutAlong}
            onClick={() => {
              const shape = shownShape();
              if (shape) void bendPhotograph(plainName(source.peek().name), shape.curve, croppedPhotograph());
            }}
          >
            {messages.deformPhoto}
          </Button>
        )}
      </div>
      {stalk.value > 0 && (
        <div class="notes stack">
          <p>{messages.hasStalk(Math.round(100 * stalk.value))}</p>
          <Button onClick={() => changeMask((now) => ({ ...now, stalk: "remove" }))}>
            {messages.removeStalk}
          </Button>
        </div>
      )}
      {spline && (withinDone.value?.bends ?? 0) > 0 && (
        <p class="hint">{messages.morphsAndDeformationsUse}</p>
      )}
      {!closed && <p class="hint">{messages.morphsAndDeformationsUseClosed}</p>}
      <div class="row">
        <span class="row-name">{messages.saveAs}</span>
        <span class={fitCss["save-buttons"]}>
          {(
            [
              ["SVG", saveSvg],
              ["CSV", saveCsv],
              ["JSON", saveJson],
              ["PNG", savePng],
            ] as const
          ).map(([name, save]) => (
            <Button
              key={name}
              disabled={!ready && closed}
              description={messages.saveAsOf(name)}
              onClick={save}
            >
              {name}
            </Button>
          ))}
        </span>
      </div>
      {running.value && closed && (
        <p class="hint" role="status">
          {waiting.value === null ? messages.stillImprovingOrB : messages.goesThereWhenDone}
        </p>
      )}
    </section>
  );
}
