import { load } from "#wasm/core";
import { client } from "../lanes/client";
import { crew } from "./crew";
import { performer } from "./performer";
import type { Tasks } from "./tasks";

/**
 * WebKit on Linux starts what its codecs stand on with the first question about a media element. An encoder that is
 * asked before that ends the whole page.
 */
function wakeCodecs(): void {
  globalThis.document?.createElement("video").canPlayType("video/webm");
}

const workers = {
  module: load,
  worker: () => {
    wakeCodecs();
    return new Worker(new URL("./film.worker.ts", import.meta.url), { type: "module", name: "frond-film" });
  },
  performer,
};

/** One worker for what is short: what can be written, and a first frame to look at. */
export const filmTask = client<Tasks, 0>({ ...workers, lane: 0 });

/** Workers for one film. */
export const filmCrew = () => crew<Tasks>(workers);
