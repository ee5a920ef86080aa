import type { ReadonlySignal } from "@preact/signals";
import { media } from "#style/media";

/** Whether it is mostly fingers that point: then keys are not what comes first. */
export const touched: ReadonlySignal<boolean> = media("(pointer: coarse)");
