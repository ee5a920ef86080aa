import "#ui/panel/fold.css";
import { homeOf, LEAST_EPSILON, MOST_ZOOM } from "#compute/locus/window";
import { endGesture } from "#document/scene";
import { zoomWords } from "#format/parameters";
import { resolutionWords } from "#format/verdict";
import { NumberField } from "#ui/controls/NumberField";
import fieldCss from "../field.module.css";
import * as messages from "../messages";
import { digitsOf } from "./geometry";
import { epsilon, family, inDigits, picked, pickPoint, setView, shownWindow, view } from "./view";

/** Nearer than this, a number takes a line of its own. */
const LONG = 1e4;

/** What the square shows, in numbers that can be typed over. */
export function WindowNumbers() {
  const { x, y, zoom } = view.value;
  const { u0, u1, v0, v1 } = shownWindow.value;
  const digits = digitsOf(zoom) + 2;
  const [across, up] = family.value === "morph" ? ["u", "v"] : ["Re s", "Im s"];
  return (
    <details class="fold window-numbers">
      <summary>
        <span class={`${fieldCss["window-words"]} number`}>
          <span>{messages.axisRange(across, inDigits(u0), inDigits(u1))}</span>{" "}
          <span>{messages.axisRange(up, inDigits(v0), inDigits(v1))}</span>
        </span>
        <span class="dim number">{zoomWords(zoom)}</span>
      </summary>
      <p class="hint">
        {(epsilon.value === LEAST_EPSILON ? messages.finestTouching : messages.touchingWithin)(
          resolutionWords(epsilon.value),
        )}
      </p>
      <div class={`${fieldCss["window-fields"]} ${zoom > LONG ? "long" : ""}`}>
        <NumberField
          label={messages.centreLabel}
          symbol={across}
          value={x}
          digits={Math.min(18, digits)}
          step={0.1 / zoom}
          onChange={(next) => setView({ x: next })}
        />
        <NumberField
          label={messages.centreLabel}
          symbol={up}
          value={y}
          digits={Math.min(18, digits)}
          step={0.1 / zoom}
          onChange={(next) => setView({ y: next })}
        />
        <NumberField
          label={messages.zoom}
          value={zoom}
          min={1}
          max={MOST_ZOOM}
          step={Math.max(0.1, zoom / 10)}
          digits={zoom < 100 ? 2 : 0}
          onChange={(next) => setView({ zoom: next })}
        />
      </div>
      <PickedFields across={across} up={up} />
    </details>
  );
}

/** The point that the picture shows off the path, to be typed. */
function PickedFields({ across, up }: { across: string; up: string }) {
  const at = picked.value ?? [view.value.x, view.value.y];
  const { zoom } = view.value;
  const digits = Math.min(18, digitsOf(zoom) + 2);
  const home = homeOf(family.value);
  return (
    <div class={`${fieldCss["window-fields"]} ${zoom > LONG ? "long" : ""}`}>
      <NumberField
        label={messages.showShapeAt}
        symbol={across}
        value={at[0]}
        min={home.u0}
        max={home.u1}
        digits={digits}
        step={0.1 / zoom}
        onChange={(next) => pickPoint([next, at[1]], "pick-number")}
        onDone={endGesture}
      />
      <NumberField
        label={messages.and}
        symbol={up}
        value={at[1]}
        min={home.v0}
        max={home.v1}
        digits={digits}
        step={0.1 / zoom}
        onChange={(next) => pickPoint([at[0], next], "pick-number")}
        onDone={endGesture}
      />
    </div>
  );
}
