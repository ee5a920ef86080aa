import { computed, type ReadonlySignal } from "@preact/signals";
import { settings } from "./mask";
import { prepared } from "./outline";
import { opened } from "./source";
import { stalkOf } from "./stalk";

const found = computed(() => (opened.value && prepared.value ? stalkOf(prepared.value.points) : 0));

/** How long the stalk is that could be taken off the photograph's outline, in parts of its size; 0: there is none. */
export const stalk: ReadonlySignal<number> = computed(() =>
  settings.value.stalk === "keep" ? found.value : 0,
);
