import type { ReadonlySignal } from "@preact/signals";
import { media } from "#style/media";

/** Where there is no room beside the time strip its settings go to the panel. */
export const narrow: ReadonlySignal<boolean> = media("(max-width: 53.6875em)");
