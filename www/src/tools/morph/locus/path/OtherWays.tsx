import { useEffect } from "preact/hooks";
import { wayOf } from "#compute/plan";
import { endBroken, type Offer, otherWays, type Search, stopLooking } from "#compute/ways";
import { announce, notify } from "#document/notice";
import { edit, scene, undo } from "#document/scene";
import { offerWords, triedWords, turnedWords } from "#format/way-words";
import pathCss from "#stage/locus/path.module.css";
import { Button } from "#ui/controls/Button";
import { isPromised, kept } from "../../shapes/promised";
import { takeWay } from "../../ways";

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
    const { what } = offerWords(best.way, best.plan, 0);
    const text = best.way ? `${what}${turnedWords(scene.peek().b.name, best.way)}` : what;
    take(best, text);
    notify({ kind: "info", text, action: { label: "Undo", run: undo } });
  }, [best, over]);
  if (endBroken.value)
    return (
      <p class="hint">One of the two shapes is itself in pieces, so that no way can hold from end to end.</p>
    );
  if (found === null) return null;
  return (
    <div class={pathCss["path-ways"]}>
      {!found.over && <Progress search={found} />}
      {found.best && (found.over || found.best.plan.holds) && <Found offer={found.best} gap={found.gap} />}
      {found.over && !found.best?.plan.holds && <p class="hint">{triedWords(found)}</p>}
    </div>
  );
}

function take({ way, plan }: Offer, words: string): void {
  edit((before) => takeWay(before, way, wayOf(plan)));
  announce(words);
}

function Progress({ search: { of, done } }: { search: Search }) {
  return (
    <div class={pathCss["path-proof-bar"]}>
      <progress
        aria-label="Other ways, being tried"
        {...(of === null ? {} : { max: Math.max(of, 1), value: done })}
      />
      <span class="hint">
        {of === null ? "Looking for other ways …" : `Trying other ways: ${done} of ${of}`}
      </span>
      <Button kind="quiet" onClick={stopLooking}>
        Stop
      </Button>
    </div>
  );
}

function Found({ offer, gap }: { offer: Offer; gap: number }) {
  const words = offerWords(offer.way, offer.plan, gap);
  return (
    <div class={pathCss["path-offer"]} role="status">
      <div>
        <strong>{words.what}</strong>
        <details>
          <summary>What becomes of the shapes</summary>
          <p>{words.why}</p>
        </details>
      </div>
      <Button description="One step, which can be undone" onClick={() => take(offer, words.what)}>
        Use it
      </Button>
    </div>
  );
}
