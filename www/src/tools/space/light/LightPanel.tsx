import { computed } from "@preact/signals";
import { endGesture } from "#document/scene";
import { changeSpace } from "#document/space/edits";
import { space } from "#document/space/space";
import { Button } from "#ui/controls/Button";
import { Segmented } from "#ui/controls/Segmented";
import { SliderField } from "#ui/controls/SliderField";
import { Switch } from "#ui/controls/Switch";
import { ChoiceRow } from "#ui/panel/ChoiceRow";
import { Fold } from "#ui/panel/Fold";
import type { SpaceLight } from "#wasm/api";
import { solid } from "#wasm/space";
import shapeCss from "../shape/shape.module.css";
import { ground } from "../stage/sight";
import { type Choice, choiceOf, chosenBackground } from "./background";
import lightCss from "./light.module.css";
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
    <div class={lightCss["space-light"]}>
      <Light />
      <Background />
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
    <section class={`${lightCss["light-panel"]} stack`} aria-label="Light and colour">
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
      <ChoiceRow
        label="Colour"
        name="What colours the picture"
        options={PAINTS}
        value={now.paint}
        onChange={(paint) => changeSpace((all) => ({ ...all, light: { ...all.light, paint } }))}
      />
      <SliderField
        digits={0}
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
      <SliderField
        digits={2}
        label="Light from the front"
        value={now.front}
        words={frontWords(now.front)}
        ends={["grazing", "from the eye"]}
        onChange={(front) => change({ front })}
      />
      <SliderField
        digits={2}
        label="Light from everywhere"
        value={now.ambient}
        words={shareWords(now.ambient, "shadows are black")}
        onChange={(ambient) => change({ ambient })}
      />
      <SliderField
        digits={2}
        label="Dark hollows"
        value={now.hollows}
        words={shareWords(now.hollows, "hollows are not darkened")}
        onChange={(hollows) => change({ hollows })}
      />
      <SliderField
        digits={2}
        label="Fog"
        value={now.fog}
        words={shareWords(now.fog, "no fog")}
        onChange={(fog) => change({ fog })}
      />
      <Finish now={now} />
    </section>
  );
}

/** What is seen at rest, and what surfaces are like. */
function Finish({ now }: { now: SpaceLight }) {
  return (
    <Fold title="Shadows and material">
      <div class="stack">
        {FINISH.map(({ part, label, none, ends }) => (
          <SliderField
            key={part}
            digits={2}
            label={label}
            value={now[part] ?? 0}
            words={shareWords(now[part] ?? 0, none)}
            {...(ends ? { ends } : {})}
            onChange={(share) => change({ [part]: share })}
          />
        ))}
        <Switch
          checked={now.filmic ?? false}
          description="Bright tones are compressed, as on film, and not cut off"
          onChange={(filmic) => changeSpace((all) => ({ ...all, light: { ...all.light, filmic } }))}
        >
          Filmic tones
        </Switch>
        <p class="hint">Shadows and ambient occlusion come when the picture rests.</p>
      </div>
    </Fold>
  );
}

const FINISH = [
  { part: "shadows", label: "Shadows", none: "no shadows are cast", ends: undefined },
  { part: "softness", label: "Softness of shadows", none: "sharp edges", ends: ["sharp", "soft"] },
  { part: "occlusion", label: "Ambient occlusion", none: "none", ends: undefined },
  { part: "sky", label: "Sky light", none: "white from everywhere", ends: ["white", "blue sky, warm sun"] },
  { part: "gloss", label: "Gloss", none: "rough", ends: ["rough", "glossy"] },
] as const;

const BACKGROUNDS: { value: Choice; label: string; description: string }[] = [
  { value: "paper", label: "Light", description: "Like light paper" },
  { value: "night", label: "Dark", description: "Like the night" },
  { value: "own", label: "Own", description: "A colour of your own" },
  { value: "page", label: "Page", description: "That of the page of whoever looks" },
];

const ABOUT: Record<Choice, string> = {
  paper: "It is part of the picture: of its link, and of what is saved.",
  night: "It is part of the picture: of its link, and of what is saved.",
  own: "It is part of the picture: of its link, and of what is saved.",
  page: "Whoever opens the link sees it before the colour of their page, light or dark. A saved PNG is clear there; a film has the colour of this page.",
};

/** What it is seen before. */
function Background() {
  const now = space.value;
  if (!now) return null;
  const choice = choiceOf(now.background);
  const set = (background: string, gesture?: string) =>
    changeSpace((all) => ({ ...all, background }), gesture === undefined ? {} : { gesture });
  return (
    <section class={`${lightCss["light-panel"]} stack`} aria-label="Background">
      <div class="section-head">
        <h2>Background</h2>
        {choice === "own" && (
          <input
            type="color"
            class={shapeCss["solid-tint"]}
            aria-label="Colour of the background"
            value={ground.value}
            onInput={(event) => set(event.currentTarget.value, "space-background")}
            onChange={endGesture}
          />
        )}
      </div>
      <Segmented
        label="What the picture is seen before"
        options={BACKGROUNDS}
        value={choice}
        onChange={(next) => set(chosenBackground(next, ground.peek()))}
      />
      <p class="hint">{ABOUT[choice]}</p>
    </section>
  );
}
