import "./light.css";
import { computed } from "@preact/signals";
import type { SpaceLight } from "../../../engine/api";
import { solid } from "../../../engine/space/module";
import { space } from "../../../state/space";
import { changeSpace } from "../../../state/space-edits";
import { Button } from "../../../ui/Button";
import { Segmented } from "../../../ui/Segmented";
import { LightSlider } from "./LightSlider";
import { ViewPanel } from "./ViewPanel";
import { degrees, frontWords, radians, shareWords, sideWords } from "./words";

const light = computed(() => space.value?.light ?? null);

const PAINTS = [
  { value: "map", label: "By map", description: "Each map has its colour" },
  { value: "height", label: "By height", description: "From the lowest point to the highest" },
] as const;

/** How space is lit and coloured, and where it is seen from. */
export function LightPanel() {
  return (
    <div class="space-light">
      <Light />
      <ViewPanel />
    </div>
  );
}

/** One setting of the light: a drag is one undo step. */
function change(part: Partial<SpaceLight>): void {
  const gesture = `space-light-${Object.keys(part).join()}`;
  changeSpace((now) => ({ ...now, light: { ...now.light, ...part } }), { gesture });
}

function Light() {
  const now = light.value;
  if (!now) return null;
  return (
    <section class="light-panel" aria-label="Light and colour">
      <div class="section-head">
        <h2>Light and colour</h2>
        <Button
          kind="quiet"
          icon="reset"
          description="Light and colours as at first"
          onClick={() => changeSpace((all) => ({ ...all, light: solid.defaultSpace().light }))}
        >
          Reset<span class="unseen"> light and colours</span>
        </Button>
      </div>
      <div class="row">
        <span class="row-name">Colour</span>
        <Segmented
          label="What colours the picture"
          options={PAINTS}
          value={now.paint}
          onChange={(paint) => changeSpace((all) => ({ ...all, light: { ...all.light, paint } }))}
        />
      </div>
      <LightSlider
        label="Light comes from"
        value={degrees(now.side)}
        min={-180}
        max={180}
        step={5}
        unit="°"
        words={sideWords(now.side)}
        ends={["below", "left", "above", "right", "below"]}
        onChange={(side) => change({ side: radians(side) })}
      />
      <LightSlider
        label="Light from the front"
        value={now.front}
        words={frontWords(now.front)}
        ends={["grazing", "from the eye"]}
        onChange={(front) => change({ front })}
      />
      <LightSlider
        label="Light from everywhere"
        value={now.ambient}
        words={shareWords(now.ambient, "shadows are black")}
        onChange={(ambient) => change({ ambient })}
      />
      <LightSlider
        label="Dark hollows"
        value={now.hollows}
        words={shareWords(now.hollows, "hollows are not darkened")}
        onChange={(hollows) => change({ hollows })}
      />
      <LightSlider
        label="Fog"
        value={now.fog}
        words={shareWords(now.fog, "no fog")}
        onChange={(fog) => change({ fog })}
      />
    </section>
  );
}
