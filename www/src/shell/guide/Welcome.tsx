import { reducedMotion } from "#document/preferences";
import { scene } from "#document/scene";
import { endsOf } from "#document/stand-in";
import { tool } from "#document/tool";
import { Button, IconButton } from "#ui/controls/Button";
import css from "./guide.module.css";
import { at, goRound, greeted, greeting, rested } from "./state";

/** The sentence of a first visit, to Frond itself or to what somebody sent. */
export function Welcome() {
  const kind = greeting.value;
  if (kind === null || at.value !== null) return null;
  return (
    <aside class={css["greeting"]} aria-label="Welcome">
      <p>
        {kind === "sent" ? sentWords() : <strong>{WHAT}</strong>}
        {kind === "new" && <Seen />}
      </p>
      <div class={css["ways"]}>
        <Button kind="primary" onClick={goRound}>
          Show me round
        </Button>
        <a class="button" href="#learn">
          Learn
        </a>
      </div>
      <IconButton class={css["close"]} icon="close" label="Close" kind="quiet" onClick={greeted} />
    </aside>
  );
}

const WHAT = "Frond turns one fractal into another without letting it fall apart.";

function sentWords() {
  const { a, b } = endsOf(scene.value);
  const turns = tool.value === "morph" && a.name !== b.name;
  return (
    <>
      {turns && (
        <strong>
          {a.name} turns into {b.name}.
        </strong>
      )}{" "}
      Made with Frond, a studio for shapes made of smaller copies of themselves.
      {turns && reducedMotion.value && " Press play to see it move."}
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
  if (rested.value) return `It is ${b.name} now. Press play to see it again.`;
  return reducedMotion.value
    ? `Press play: ${a.name} turns into ${b.name}.`
    : "Each colour is a smaller copy of the whole.";
}
