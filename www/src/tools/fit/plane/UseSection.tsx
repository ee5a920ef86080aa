import { Button } from "#ui/controls/Button";
import * as messages from "../messages";
import { MOST_MAPS, plainMaps } from "./model/curve";
import { maps } from "./model/document";
import { outlineOf, systemOf, takeOutline, takeSystem } from "./use";

/** Where the curve goes from here. */
export function UseSection() {
  const now = maps.value;
  const plain = now && plainMaps(now);
  const rows = plain && plain.length <= MOST_MAPS ? plain : null;
  const take = (to: "a" | "b" | "bent") => {
    const system = systemOf();
    if (system) takeSystem(system, to);
    else {
      const outline = outlineOf();
      if (outline) takeOutline(outline, to);
    }
  };
  return (
    <section class="stack" aria-label={messages.use}>
      <div class="section-head">
        <h2>{messages.use}</h2>
      </div>
      <div class="row">
        <Button kind="primary" icon="arrow" disabled={!now} onClick={() => take("a")}>
          {messages.useAs}
        </Button>
        <Button disabled={!now} description={messages.becomesLastShapeMorph} onClick={() => take("b")}>
          {messages.useAsB}
        </Button>
        <Button disabled={!now} onClick={() => take("bent")}>
          {messages.deform}
        </Button>
      </div>
      <p class="hint">{rows ? messages.attractorOf(rows.length) : messages.mapsNeedTBesides}</p>
    </section>
  );
}
