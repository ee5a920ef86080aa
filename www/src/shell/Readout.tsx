import { computed } from "@preact/signals";
import { here, locusView, selection } from "#document/morph";
import { scene } from "#document/scene";
import { standIn } from "#document/stand-in";
import { tool } from "#document/tool";
import { fixed } from "#format/numbers";
import { countWords } from "#format/verdict";
import { fitStage } from "#stage/gestures";
import { picture } from "#stage/stage";
import { outOfView, view, zoom } from "#stage/view";
import { withKey } from "#ui/commands";
import { workers } from "#workers/pool/engine";
import { Glyph } from "./glyphs";
import * as messages from "./messages";

const zoomWords = computed(() => {
  // A quarter more is a quarter more, whatever rounding made of it.
  const z = Number(zoom.value.toPrecision(9));
  if (z < 10) return `×${z.toFixed(1)}`;
  return z < 1e4 ? `×${Math.round(z)}` : `×${z.toExponential(1)}`;
});

/** How much is drawn, and how near one is. */
export function Readout() {
  const [x, y] = here.value;
  return (
    <div class="readout number">
      {!selection.value && tool.value === "morph" && (
        <span class="readout-uv">
          {standIn.value
            ? messages.partOfThePath((100 * scene.value.t).toFixed(0))
            : locusView.value.family === "morph"
              ? messages.turnAndMove(fixed(x), fixed(y))
              : `s ${fixed(x)} ${y < 0 ? "−" : "+"} ${fixed(Math.abs(y))} i`}
        </span>
      )}
      {picture.value.points > 0 && (
        <span class="readout-points">
          {countWords(picture.value.points)} {picture.value.points === 1 ? "point" : "points"}
        </span>
      )}
      {outOfView.value && <span class="readout-points">{messages.partOutOfView}</span>}
      {!workers.value.available && <span>{messages.noWorkers}</span>}
      <span data-testid="zoom">{zoomWords.value}</span>
      <button
        type="button"
        class="button quiet icon-button"
        aria-label={messages.fitToStage}
        title={withKey(messages.fitToStage, "fit")}
        disabled={view.value === null && !outOfView.value}
        onClick={fitStage}
      >
        <Glyph name="fit" />
      </button>
    </div>
  );
}
