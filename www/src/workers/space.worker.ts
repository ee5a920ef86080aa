import type { Ask } from "#engine/lanes/task";
import { performer } from "#engine/space/performer";

const perform = performer((answer, transfer) => self.postMessage(answer, { transfer }));

self.addEventListener("message", (event: MessageEvent<Ask>) => perform(event.data));
