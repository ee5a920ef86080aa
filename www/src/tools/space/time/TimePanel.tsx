import { changeTimeline, EMPTY_LINE } from "#document/space/edits";
import { space, timeline } from "#document/space/space";
import { Button, IconButton } from "#ui/controls/Button";
import { ChoiceRow } from "#ui/panel/ChoiceRow";
import { scrubSpace } from "./clock";
import { fly } from "./flight/flight";
import { EaseMenu, KeyOptions } from "./keys/KeyOptions";
import { keyHere } from "./keys/Keys";
import { attempt, removeKey } from "./keys/keys";
import * as messages from "./messages";
import { openAnimation } from "./saved/open";
import { LoopRow, TimeNumbers } from "./TimeFields";
import { ExportButton } from "./TimeStrip";
import css from "./time.module.css";
import { easeWords, keyWords, secondsWords } from "./time-text";

const COURSES = [
  { value: "smooth", label: messages.smooth, description: messages.withoutJerksAtKeyframes },
  { value: "straight", label: messages.straight, description: messages.straightBetweenKeyframes },
] as const;

/** All of time as numbers and a list: what the strip has no room for. */
export function TimePanel() {
  const line = timeline.value;
  return (
    <section class="stack" aria-label={messages.timeAndKeyframes}>
      <div class="section-head">
        <h2>{messages.time}</h2>
        <ExportButton />
      </div>
      <div class={css["time-fields"]}>
        <TimeNumbers terse={false} />
      </div>
      <LoopRow />
      <ChoiceRow
        label={messages.betweenKeyframes}
        options={COURSES}
        value={(line ?? space.value?.timeline ?? EMPTY_LINE).course}
        onChange={(course) => attempt(() => changeTimeline((now) => ({ ...now, course })))}
      />
      <div class={css["time-ready"]}>
        <Button onClick={() => fly("through")}>{messages.flyThrough}</Button>
        <Button onClick={() => fly("around")}>{messages.flyAround}</Button>
        <Button kind="quiet" onClick={openAnimation}>
          {messages.open}
        </Button>
      </div>
      {line ? <KeyList /> : <p class="hint">{messages.noAnimationYetThere}</p>}
      <KeyOptions />
    </section>
  );
}

function KeyList() {
  const keys = timeline.value?.keys ?? [];
  return (
    <ol class={css["key-list"]}>
      {keys.map((key, index) => (
        // Keys keep their order, so their number is their name.
        <li key={index} class={keyHere.value === index ? "chosen" : ""}>
          <Button kind="quiet" class={css["key-go"]} onClick={() => scrubSpace(key.at)}>
            <span class="number">{secondsWords(key.at)}</span>
            <span class={`dim ${css["key-about"]}`}>
              {keyWords(key)}
              {index < keys.length - 1 && <span>{messages.thenEase(easeWords(key.ease))}</span>}
            </span>
          </Button>
          <EaseMenu of={key} index={index} />
          <IconButton
            icon="bin"
            label={messages.deleteKey(index + 1)}
            kind="quiet"
            onClick={() => removeKey(index)}
          />
        </li>
      ))}
    </ol>
  );
}
