import { useEffect } from "preact/hooks";
import { wayOf } from "#compute/plan";
import { endBroken, type Offer, otherWays, type Search, stopLooking } from "#compute/ways";
import { notify } from "#document/notice";
import { edit, scene, undo } from "#document/scene";
import { offerWords, triedWords } from "#format/way-words";
import pathCss from "#stage/locus/path.module.css";
import { Button } from "#ui/controls/Button";
import { isPromised, kept } from "../../shapes/promised";
import { takeWay } from "../../ways";
import * as messages from "../messages";

/** Where the automatic path breaks: what else was tried by itself, and what came of it. */
export function OtherWays() {
  const found = otherWays.value;
  const { best, over } = found ?? {};
  useEffect(() => {
    if (!isPromised(scene.peek())) return;
    // What was promised is not found in the time that there is.
    if (over && !best?.plan.holds) kept();
    if (!best?.plan.holds) return;
    kept();
    // The shapes are as somebody has just chosen them: what would change them is offered.
    notify({
      kind: "info",
      text: wordsOf(best).what,
      action: { label: messages.apply, run: () => take(best) },
    });
  }, [best, over]);
  if (endBroken.value) return <p class="hint">{messages.oneTwoShapesIn}</p>;
  if (found === null) return null;
  return (
    <div class={pathCss["path-ways"]}>
      {!found.over && <Progress search={found} />}
      {found.best && (found.over || found.best.plan.holds) && <Found offer={found.best} gap={found.gap} />}
      {found.over && !found.best?.plan.holds && <p class="hint">{triedWords(found)}</p>}
    </div>
  );
}

const wordsOf = ({ way, plan }: Offer, gap = 0) => offerWords(way, plan, gap, scene.peek().b.name);

function take(offer: Offer): void {
  const { what } = wordsOf(offer, otherWays.peek()?.gap);
  edit((before) => takeWay(before, offer.way, wayOf(offer.plan)));
  notify({ kind: "info", text: messages.doneWhat(what), action: { label: messages.undo, run: undo } });
}

function Progress({ search: { of, done } }: { search: Search }) {
  return (
    <div class={pathCss["path-proof-bar"]}>
      <progress
        aria-label={messages.tryingOtherPaths}
        {...(of === null ? {} : { max: Math.max(of, 1), value: done })}
      />
      <span class="hint">{of === null ? messages.searchingForOtherPaths : messages.tryingOf(done, of)}</span>
      <Button kind="quiet" onClick={stopLooking}>
        {messages.stop}
      </Button>
    </div>
  );
}

function Found({ offer, gap }: { offer: Offer; gap: number }) {
  const words = wordsOf(offer, gap);
  return (
    <div class={pathCss["path-offer"]} role="status">
      <div>
        <strong>{words.what}</strong>
        <details>
          <summary>{messages.whatThisChanges}</summary>
          <p>{words.why}</p>
        </details>
      </div>
      <Button description={messages.singleUndoStep} onClick={() => take(offer)}>
        {messages.apply}
      </Button>
    </div>
  );
}
