import { Button } from "#ui/controls/Button";
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
    <section class="stack" aria-label="Use it">
      <div class="section-head">
        <h2>Use it</h2>
      </div>
      <div class="row">
        <Button kind="primary" icon="arrow" disabled={!now} onClick={() => take("a")}>
          Use as A
        </Button>
        <Button
          disabled={!now}
          description="The last shape of the morph, instead of the first"
          onClick={() => take("b")}
        >
          Use as B
        </Button>
        <Button disabled={!now} onClick={() => take("bent")}>
          Bend it
        </Button>
      </div>
      <p class="hint">
        {rows
          ? `It is the attractor of ${rows.length} maps of the plane, and goes along as such, exactly.`
          : "Its maps need t beside x and y, so it goes along as an outline of short straight sides, closed from its last point to its first."}
      </p>
    </section>
  );
}
