import { reducedMotion } from "#document/preferences";
import { scene } from "#document/scene";
import { endsOf } from "#document/stand-in";
import { tool } from "#document/tool";
import { Button, IconButton } from "#ui/controls/Button";
import css from "./guide.module.css";
import * as messages from "./messages";
import { at, goRound, greeted, greeting, rested } from "./state";

/** The sentence of a first visit, to Frond itself or to what somebody sent. */
export function Welcome() {
  const kind = greeting.value;
  if (kind === null || at.value !== null) return null;
  return (
    <aside class={css["greeting"]} aria-label={messages.welcome}>
      <p>
        {kind === "sent" ? sentWords() : <strong>{WHAT}</strong>}
        {kind === "new" && <Seen />}
      </p>
      <div class={css["ways"]}>
        <Button kind="primary" onClick={goRound}>
          {messages.takeTour}
        </Button>
        <a class="button" href="#learn">
          {messages.learn}
        </a>
      </div>
      <IconButton class={css["close"]} icon="close" label={messages.close} kind="quiet" onClick={greeted} />
    </aside>
  );
}

const WHAT = messages.frondTurnsOneFractal;

function sentWords() {
  const { a, b } = endsOf(scene.value);
  const turns = tool.value === "morph" && a.name !== b.name;
  return (
    <>
      {turns && <strong>{messages.turnsInto(a.name, b.name)}</strong>} {messages.madeWithFrond}
      {turns && reducedMotion.value && ` ${messages.pressPlayToMove}`}
    </>
  );
}

/** What is seen of it just now: as long before as after, so that nothing moves. */
function Seen() {
  return (
    <span class={css["seen"]} role="status">
      {seenWords()}
    </span>
  );
}

function seenWords(): string {
  const { a, b } = endsOf(scene.value);
  if (rested.value) return messages.nowPressPlayTo(b.name);
  return reducedMotion.value ? messages.pressPlayToWatch(a.name, b.name) : messages.eachColourSmallerCopy;
}
