import { verdict } from "#compute/results";
import { FIRST_S, uv } from "#document/morph";
import { announce, notify } from "#document/notice";
import { edit } from "#document/scene";
import { fixed } from "#format/numbers";
import { complexWords } from "#format/parameters";
import { verdictPhrase } from "#format/verdict";
import { Button } from "#ui/controls/Button";
import { Term } from "#ui/terms/Term";
import type { TermName } from "#ui/terms/words";
import { type End, nameOf } from "../../edits";
import fieldCss from "../field.module.css";
import * as messages from "../messages";
import { addAt } from "../path/waypoints";
import { digitsOf } from "../view/geometry";
import { backToPath, family, picked, setPlane, sides, view } from "../view/view";
import { familyMaps } from "./hover";

/** Where the picture is now, in numbers, and what can be done with a point that was taken off the path. */
export function Now() {
  return family.value === "morph" ? <OfMorph /> : <OfFamily />;
}

function OfMorph() {
  const at = picked.value;
  const [u, v, w = 0] = at ?? uv.value;
  // A point on the path moves with the picture: two decimals, so that they do not dance.
  const digits = at ? Math.max(2, digitsOf(view.value.zoom)) : 2;
  const third = w !== 0 || view.value.w !== 0;
  return (
    <div class="locus-now">
      <dl>
        <Value name={messages.rotateAndStretch} term="u and v" symbol="u" value={fixed(u, digits)} />
        <Value name={messages.move} term="u and v" symbol="v" value={fixed(v, digits)} />
        {third && <Value name={messages.stretchLead} symbol="w" value={fixed(w, 2)} />}
      </dl>
      {at && <There />}
      {at && (
        <div class={fieldCss["locus-act"]}>
          <Button onClick={backToPath}>{messages.backToPath}</Button>
          <Button
            onClick={() => {
              const [x, y, z = 0] = at;
              backToPath();
              addAt([x, y, z]);
            }}
          >
            {messages.addAsWaypoint}
          </Button>
        </div>
      )}
    </div>
  );
}

/** What is known of the point that was picked: what the stage says of it, since one sample of the map may say less. */
function There() {
  const known = verdict.value;
  if (!known || known.stale) return null;
  return <p class="hint">{messages.atPoint(verdictPhrase(known.connectedness, known.epsilon))}</p>;
}

interface ValueProps {
  name: string;
  term?: TermName;
  symbol: string;
  value: string;
}

function Value({ name, term, symbol, value }: ValueProps) {
  return (
    <div>
      <dt>{term ? <Term name={term}>{name}</Term> : name}</dt>
      <dd>
        <span class="symbol">{symbol}</span> <output>{value}</output>
      </dd>
    </div>
  );
}

function OfFamily() {
  const s = picked.value ?? FIRST_S;
  const n = sides.value;
  const words = complexWords(s, Math.max(3, digitsOf(view.value.zoom)));
  return (
    <div class="locus-now">
      <dl>
        <Value name={messages.rotateAndShrink} term="M" symbol="s" value={words} />
      </dl>
      <There />
      <div class={fieldCss["locus-act"]}>
        <Button onClick={() => use("a", n, s)} description={messages.morphThenStartsWith}>
          {messages.useAs}
        </Button>
        <Button onClick={() => use("b", n, s)} description={messages.morphThenEndsWith}>
          {messages.useAsB}
        </Button>
      </div>
    </div>
  );
}

/** Puts a shape of a family at one end of the morph. */
function use(end: End, n: number, s: [number, number, number?]): void {
  const maps = familyMaps(n, s);
  if (!maps) {
    notify({ kind: "error", text: messages.thisShapeCouldNot });
    return;
  }
  const name = messages.nameAt(n === 2 ? "M" : messages.gon(n), complexWords(s, 3));
  edit((before) => ({ ...before, [end]: { name, maps }, correspondence: [], turns: [] }));
  announce(messages.shapeNow(nameOf(end), name));
  notify({
    kind: "info",
    text: messages.shapeNow(nameOf(end), name),
    action: { label: messages.showMorph, run: () => setPlane("morph", 2) },
  });
}
