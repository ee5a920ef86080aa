/** Talks with the page around the frame, and with nobody else. */
import { effect } from "@preact/signals";
import { verdict } from "#compute/results";
import { phasePlaying } from "#document/deform/bend";
import { parseRoute } from "#document/link";
import { playing, spacePlaying } from "#document/playback";
import { scene } from "#document/scene";
import { standIn } from "#document/stand-in";
import { verdictLine } from "#format/verdict";
import { frond } from "#wasm/core";
import { link } from "../actions";
import { openedTool } from "../tools";
import { type Asked, askedBy, type Told } from "./protocol";

/** Whether what moves plays, in whichever tool. */
export const moving = (): boolean => playing.value || phasePlaying.value || spacePlaying.value;

/** The moment of the tool that is open, 0 to 1; follows the document. */
export function momentNow(): number {
  scene.value;
  const line = openedTool().tool?.timeline;
  return line && line.length() > 0 ? line.now() / line.length() : 0;
}

export function seek(t: number): void {
  const line = openedTool().tool?.timeline;
  line?.seek(t * line.length());
}

/** Listens until the returned function is called. With an `origin`, to that one only. */
export function talk(origin: string | null): () => void {
  let listener: string | null = null;
  const tell = (message: Told, to = listener) => {
    // A file that is opened without a server has no origin to be named.
    if (to !== null) parent.postMessage({ frond: 1, ...message }, to === "null" ? "*" : to);
  };
  const state = (): Told => ({
    type: "state",
    t: momentNow(),
    playing: moving(),
    fragment: link.fragment() ?? "",
  });
  const hear = (event: MessageEvent) => {
    if (event.source !== parent || parent === window) return;
    if (origin !== null && event.origin !== origin) return;
    const asked = askedBy(event.data);
    if (asked === null) return;
    if (typeof asked === "string") {
      tell({ type: "error", message: asked }, event.origin);
      return;
    }
    if (asked.type === "hello") {
      listener = event.origin;
      tell(state());
      return;
    }
    const problem = act(asked);
    if (problem !== null) tell({ type: "error", message: problem }, event.origin);
  };
  addEventListener("message", hear);
  // It says nothing of the document, so anybody may have it.
  if (parent !== window) tell({ type: "ready" }, origin ?? "*");
  const stops = [
    effect(() => tell(state())),
    effect(() => {
      const known = verdict.value;
      if (!known || known.stale || standIn.value) return;
      const { connectedness } = known;
      tell({ type: "verdict", verdict: connectedness.verdict, words: verdictLine(connectedness) });
    }),
  ];
  return () => {
    removeEventListener("message", hear);
    for (const stop of stops) stop();
  };
}

/** What is wrong with what was asked for, in words: then all stays as it is. */
function act(asked: Exclude<Asked, { type: "hello" }>): string | null {
  if (asked.type === "open") return open(asked.fragment);
  if (asked.type === "seek") seek(asked.t);
  else if (moving() !== (asked.type === "play")) openedTool().tool?.timeline?.toggle();
  return null;
}

function open(fragment: string): string | null {
  const problem = parseRoute(fragment).page === "studio" ? frond.decodeScene(fragment).problem : undefined;
  // Of a link of a later version it shows what it can.
  if (problem && problem.code !== "link-later") return problem.message;
  location.replace(`#${fragment}`);
  return null;
}
