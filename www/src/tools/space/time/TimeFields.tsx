import { endGesture } from "#document/scene";
import { changeTimeline, EMPTY_LINE } from "#document/space/edits";
import { moment, space, timeline } from "#document/space/space";
import { NumberField, type NumberFieldProps } from "#ui/controls/NumberField";
import { Menu } from "#ui/overlay/Menu";
import { ChoiceRow } from "#ui/panel/ChoiceRow";
import type { Repeat } from "#wasm/api";
import { pauseSpace, scrubSpace } from "./clock";
import { attempt } from "./keys/keys";
import * as messages from "./messages";
import css from "./time.module.css";
import { jumpsBack, LONGEST, SHORTEST, secondsProblem, withLoop, withSeconds } from "./time-edits";
import { LOOPS, loopOf } from "./time-text";

/** Where there is no room at a field, what takes the words about what was wrong. */
export interface Problems {
  problems?: NonNullable<NumberFieldProps["problems"]>;
}

interface MomentFieldProps extends Problems, Pick<NumberFieldProps, "label" | "value" | "onChange"> {
  /** How long the time line is. */
  seconds: number;
  terse?: boolean;
  onDone?: () => void;
}

/** A moment of the time line. */
export function MomentField({ seconds, ...field }: MomentFieldProps) {
  return <NumberField {...field} min={0} max={seconds} step={0.1} digits={2} unit="s" />;
}

/** The moment and the length as numbers. */
export function TimeNumbers({ terse = true, problems }: Problems & { terse?: boolean }) {
  const line = timeline.value ?? space.value?.timeline ?? EMPTY_LINE;
  const told = problems ? { problems } : {};
  return (
    <>
      <MomentField
        {...told}
        terse={terse}
        label={messages.moment}
        value={moment.value}
        seconds={line.seconds}
        onChange={scrubSpace}
      />
      {terse && (
        <span class={css["time-of"]} aria-hidden="true">
          {messages.ofLabel}
        </span>
      )}
      <NumberField
        {...told}
        terse={terse}
        label={messages.length}
        value={line.seconds}
        min={SHORTEST}
        max={LONGEST}
        step={0.5}
        digits={2}
        unit="s"
        onChange={(seconds) => {
          const problem = secondsProblem(line, seconds);
          if (problem !== undefined) return problem;
          pauseSpace();
          attempt(() => changeTimeline((now) => withSeconds(now, seconds), { gesture: "space seconds" }));
          scrubSpace(moment.peek());
          return undefined;
        }}
        onDone={endGesture}
      />
    </>
  );
}

const lineNow = () => timeline.value ?? space.value?.timeline ?? EMPTY_LINE;

function choose(loop: Repeat): void {
  pauseSpace();
  attempt(() => changeTimeline((now) => withLoop(now, loop)));
}

/** What comes after the end, where there is little room. */
export function LoopMenu() {
  const { loop } = lineNow();
  const now = loopOf(loop);
  const what = messages.loopIs(now?.label.toLowerCase() ?? "");
  return (
    <div title={what}>
      <Menu
        label={what}
        icon={now?.icon ?? "loop"}
        items={LOOPS.map(({ value, label }) => ({
          label,
          ...(value === loop ? { icon: "check" as const } : {}),
          onSelect: () => choose(value),
        }))}
      />
    </div>
  );
}

/** The same with all choices in view, and with what it comes to. */
export function LoopRow() {
  const line = lineNow();
  return (
    <>
      <ChoiceRow label={messages.loop} options={LOOPS} value={line.loop} onChange={choose} />
      {jumpsBack(line) && <p class="hint">{messages.lastKeyframeAtVery}</p>}
    </>
  );
}
