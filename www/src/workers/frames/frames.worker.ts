import type { Ask } from "../lanes/task";
import { performer } from "./performer";

const perform = performer((answer, transfer) => self.postMessage(answer, { transfer }));

self.addEventListener("message", (event: MessageEvent<Ask>) => perform(event.data));
