/** What every job about the locus begins with. */
import { computed } from "@preact/signals";
import { morphOptions, pairing } from "#document/morph";
import type { LocusInputs } from "./locus/job";

/** All that the locus hangs on: a new object when any of it changes. */
export const inputs = computed<LocusInputs>(() => ({
  from: pairing.value.from,
  to: pairing.value.to,
  options: morphOptions.value,
}));
