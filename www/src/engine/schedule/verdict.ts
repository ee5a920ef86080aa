import { effect, untracked } from "@preact/signals";
import { here, selection, shown } from "../../state/morph";
import type { MapRow, PathPoint } from "../api";
import { Coalesce } from "../coalesce";
import { epoch, submit } from "../engine";
import { EPSILON } from "../locus-job";
import { single } from "../protocol";
import { publish } from "../results";

const queue = new Coalesce(submit);

/** What is said of the stage follows the stage, never more than one answer behind. */
export function scheduleVerdict(): void {
  effect(() => {
    epoch.value;
    untracked(() => queue.reset());
  });
  effect(() => {
    const maps = shown.value;
    const at = here.value;
    epoch.value;
    selection.value;
    untracked(() => {
      const before = publish.verdict.peek();
      if (before && !before.stale) publish.verdict.value = { ...before, stale: true };
      queue.request(() => judge(maps, at));
    });
  });
}

function judge(maps: MapRow[], at: PathPoint) {
  return single<"verdict">(
    "verdict",
    60,
    { kind: "verdict", maps, epsilon: EPSILON },
    {
      accept: (connectedness) => {
        publish.verdict.value = { connectedness, uv: at, stale: maps !== shown.peek() };
      },
      fail: (error) => {
        // Maps without an attractor are a state like any other; whatever else fails is the caller's to see.
        const none = maps.map((_, i) => i);
        publish.verdict.value = {
          connectedness: {
            verdict: error.code === "worker-lost" ? "undecided" : "no-attractor",
            gap: { lower: 0, upper: 0 },
            overlaps: [],
            components: none,
            count: none.length,
            diameter: 0,
            nodes: 0,
          },
          uv: at,
          stale: maps !== shown.peek(),
        };
      },
    },
  );
}
