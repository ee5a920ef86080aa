/** What is said of the shape on the stage. */
import { computed, effect, untracked } from "@preact/signals";
import { here, locusView, selection, shown, shownPick } from "#document/morph";
import { scene } from "#document/scene";
import type { MapRow, PathPoint } from "#wasm/api";
import { Coalesce } from "#workers/pool/coalesce";
import { epoch, submit } from "#workers/pool/engine";
import { single } from "#workers/pool/protocol";
import { detail } from "./locus/detail";
import { EPSILON } from "./locus/job";
import { clampedView, epsilonOf, levelOf, viewProblem } from "./locus/window";
import { publish } from "./results";

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
    const epsilon = resolution.value;
    const pick = shownPick.value;
    epoch.value;
    selection.value;
    untracked(() => {
      const before = publish.verdict.peek();
      if (before && !before.stale) publish.verdict.value = { ...before, stale: true };
      queue.request(() => judge({ maps, at, epsilon, sides: pick?.sides ?? null }));
    });
  });
}

/**
 * What the stage is looked at with: a point that was picked on the map, as finely as the map shows it; a moment of the
 * path, as the path is.
 */
const resolution = computed(() => {
  const view = locusView.value;
  if (!shownPick.value || viewProblem(view) !== null) return EPSILON;
  return epsilonOf(levelOf(clampedView(view).zoom * detail.value));
});

interface What {
  maps: MapRow[];
  at: PathPoint;
  epsilon: number;
  /** Of the polygon family that the maps are of, if they are. */
  sides: number | null;
}

function judge({ maps, at, epsilon, sides }: What) {
  const polygon = sides === null ? {} : { polygon: { sides, s: at } };
  const stale = () => maps !== shown.peek() || epsilon !== resolution.peek();
  return single<"verdict">(
    "verdict",
    60,
    { kind: "verdict", maps, epsilon, ...polygon },
    {
      accept: (connectedness) => {
        publish.verdict.value = { connectedness, epsilon, uv: at, stale: stale() };
        const { t } = scene.peek();
        // What doubles leave open may be proved of the numbers that they stand for.
        if (connectedness.verdict !== "connected" && !stale() && (selection.peek() || t === 0 || t === 1))
          void import("./exact").then(({ settle }) => settle(maps, epsilon)).catch(() => {});
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
          epsilon,
          uv: at,
          stale: stale(),
        };
      },
    },
  );
}
