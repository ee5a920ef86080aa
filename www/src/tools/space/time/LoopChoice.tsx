import { changeTimeline, EMPTY_LINE } from "#document/space/edits";
import { space, timeline } from "#document/space/space";
import { Menu } from "#ui/overlay/Menu";
import { ChoiceRow } from "#ui/panel/ChoiceRow";
import type { Repeat } from "#wasm/api";
import { jumpsBack, withLoop } from "./changes";
import { pauseSpace } from "./clock";
import { attempt } from "./keys/keys";
import * as messages from "./messages";
import { LOOPS, loopOf } from "./words";

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
