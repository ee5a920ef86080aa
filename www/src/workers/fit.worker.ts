import { performer } from "#engine/fit/performer";
import type { Ask } from "#engine/lanes/task";

const perform = performer((answer, transfer) => self.postMessage(answer, { transfer }));

self.addEventListener("message", (event: MessageEvent<Ask>) => perform(event.data));
