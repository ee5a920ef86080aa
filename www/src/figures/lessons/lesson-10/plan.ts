/** The shapes of this lesson, and the best way of a pairing between them. */
import { useMemo, useState } from "preact/hooks";
import type { PathPlan } from "#wasm/api";
import type { Task } from "#workers/pool/protocol";
import { preset } from "../../kit/frame/studio-link";
import type { Ends } from "../../kit/maps/morphs";
import { useAsk } from "../../kit/workers";
import { TURNS } from "./pairings";

const EPSILON = 1 / 600;

export const FIRST = [
  { value: "dragon-3", label: "Heighway’s dragon" },
  { value: "terdragon-mirrored", label: "Mirrored terdragon" },
] as const;
export type First = (typeof FIRST)[number]["value"];
export const LAST = "gasket";

export const endsOf = (first: First): Ends => ({ from: preset(first).maps, to: preset(LAST).maps });

export const turnsOf = (first: First): number[] => (first === "dragon-3" ? TURNS : []);

/** The best path of a pairing, or null until it is found. */
export function usePlan(ends: Ends, pairing: readonly number[], first: First = "dragon-3"): PathPlan | null {
  const [found, setFound] = useState<{ of: object; plan: PathPlan } | null>(null);
  const task = useMemo<Task<"plan3">>(
    () => ({
      kind: "plan3",
      ...ends,
      options: { correspondence: [...pairing], turns: turnsOf(first), epsilon: EPSILON },
    }),
    [ends, pairing, first],
  );
  useAsk<"plan3">(task, 36, { accept: (of, plan) => setFound({ of, plan }) });
  return found && found.of === task ? found.plan : null;
}
