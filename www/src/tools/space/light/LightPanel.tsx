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
import * as messages from "../messages";
import shapeCss from "../shape/shape.module.css";
import { ground } from "../stage/sight";
import {
  type Choice,
  choiceOf,
  chosenBackground,
  degrees,
  frontWords,
  radians,
  shareWords,
  sideWords,
} from "./light";
import lightCss from "./light.module.css";
import { ViewPanel } from "./ViewPanel";

const light = computed(() => space.value?.light ?? null);

const PAINTS = [
  { value: "map", label: messages.byMap, description: messages.eachMapHasOwn },
  { value: "height", label: messages.byHeight, description: messages.fromLowestPointTo },
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
    <section class={`${lightCss["light-panel"]} stack`} aria-label={messages.lightAndColour}>
      <div class="section-head">
        <h2>{messages.lightAndColour}</h2>
        <Button
          kind="quiet"
          icon="reset"
          description={messages.resetLightAndColours}
          onClick={() => changeSpace((all) => ({ ...all, light: solid.defaultSpace().light }))}
        >
          {messages.reset}
          <span class="unseen">{messages.lightAndColours}</span>
        </Button>
      </div>
      <ChoiceRow
        label={messages.colour}
        name={messages.colourSource}
        options={PAINTS}
        value={now.paint}
        onChange={(paint) => changeSpace((all) => ({ ...all, light: { ...all.light, paint } }))}
      />
      <SliderField
        digits={0}
        label={messages.lightDirection}
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
        label={messages.frontalLight}
        value={now.front}
        words={frontWords(now.front)}
        ends={["grazing", messages.fromViewer]}
        onChange={(front) => change({ front })}
      />
      <SliderField
        digits={2}
        label={messages.ambientLight}
        value={now.ambient}
        words={shareWords(now.ambient, messages.shadowsBlack)}
        onChange={(ambient) => change({ ambient })}
      />
      <SliderField
        digits={2}
        label={messages.ambientOcclusion}
        value={now.hollows}
        words={shareWords(now.hollows, messages.none)}
        onChange={(hollows) => change({ hollows })}
      />
      <SliderField
        digits={2}
        label={messages.fog}
        value={now.fog}
        words={shareWords(now.fog, messages.noFog)}
        onChange={(fog) => change({ fog })}
      />
      <Finish now={now} />
    </section>
  );
}

/** What is seen at rest, and what surfaces are like. */
function Finish({ now }: { now: SpaceLight }) {
  return (
    <Fold title={messages.shadowsAndMaterial}>
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
          description={messages.compressesBrightTonesAs}
          onChange={(filmic) => changeSpace((all) => ({ ...all, light: { ...all.light, filmic } }))}
        >
          {messages.filmicTones}
        </Switch>
        <p class="hint">{messages.shadowsAndAmbientOcclusion}</p>
      </div>
    </Fold>
  );
}

const FINISH = [
  { part: "shadows", label: messages.shadows, none: messages.noShadowsCast, ends: undefined },
  { part: "softness", label: messages.softnessShadows, none: messages.sharpEdges, ends: ["sharp", "soft"] },
  { part: "occlusion", label: messages.ambientOcclusion, none: "none", ends: undefined },
  {
    part: "sky",
    label: messages.skyLight,
    none: messages.uniformWhiteLight,
    ends: ["white", messages.blueSkyWarmSun],
  },
  { part: "gloss", label: messages.gloss, none: "rough", ends: ["rough", "glossy"] },
] as const;

const BACKGROUNDS: { value: Choice; label: string; description: string }[] = [
  { value: "paper", label: messages.light, description: messages.likeLightPaper },
  { value: "night", label: messages.dark, description: messages.likeNight },
  { value: "own", label: messages.custom, description: messages.yourOwnColour },
  { value: "page", label: messages.page, description: messages.backgroundViewersPage },
];

const ABOUT: Record<Choice, string> = {
  paper: messages.partPictureLinkAnd,
  night: messages.partPictureLinkAnd,
  own: messages.partPictureLinkAnd,
  page: messages.anyoneWithLinkSees,
};

/** What it is seen before. */
function Background() {
  const now = space.value;
  if (!now) return null;
  const choice = choiceOf(now.background);
  const set = (background: string, gesture?: string) =>
    changeSpace((all) => ({ ...all, background }), gesture === undefined ? {} : { gesture });
  return (
    <section class={`${lightCss["light-panel"]} stack`} aria-label={messages.background}>
      <div class="section-head">
        <h2>{messages.background}</h2>
        {choice === "own" && (
          <input
            type="color"
            class={shapeCss["solid-tint"]}
            aria-label={messages.backgroundColour}
            value={ground.value}
            onInput={(event) => set(event.currentTarget.value, "space-background")}
            onChange={endGesture}
          />
        )}
      </div>
      <Segmented
        label={messages.background}
        options={BACKGROUNDS}
        value={choice}
        onChange={(next) => set(chosenBackground(next, ground.peek()))}
      />
      <p class="hint">{ABOUT[choice]}</p>
    </section>
  );
}
