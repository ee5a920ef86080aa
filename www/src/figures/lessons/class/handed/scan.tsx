import { useEffect, useRef, useState } from "preact/hooks";
import { Button } from "#ui/controls/Button";
import { Dialog } from "#ui/overlay/Dialog";
import type { CodeReader } from "#workers/codes/client";
import fieldCss from "../../../kit/frame/field.module.css";
import layout from "../../../kit/frame/layout.module.css";
import css from "./scan.module.css";

/** What was read, in a sentence; and whether it was no answers. */
export interface Heard {
  words: string;
  problem: boolean;
}

interface ScanProps {
  /** Takes the text of a code. */
  onCode: (text: string) => Heard;
  /** How many have handed in. */
  count: string;
  /** How many there are in the class; null where nobody said. */
  size: number | null;
  onSize: (size: number | null) => void;
  onClose: () => void;
}

/** So many of what was heard last stay in sight. */
const MOST_HEARD = 5;
/** A frame is looked at when the one before has been, and no sooner than so many milliseconds after it. */
const REST_MS = 40;

/** Scans one QR code after the other by the camera. */
export function Scan({ onCode, count, size, onSize, onClose }: ScanProps) {
  const video = useRef<HTMLVideoElement>(null);
  const [state, setState] = useState<"asking" | "live" | { problem: string }>("asking");
  const [heard, setHeard] = useState<readonly (Heard & { id: number })[]>([]);
  const [cameras, setCameras] = useState<readonly string[]>([]);
  const [wanted, setWanted] = useState<string | null>(null);
  const [tries, setTries] = useState(0);
  const take = useRef(onCode);
  take.current = onCode;

  // biome-ignore lint/correctness/useExhaustiveDependencies: each try asks again
  useEffect(() => {
    const end = new AbortController();
    setState("asking");
    let last = "";
    let id = heard[0]?.id ?? 0;
    const listen = (texts: readonly string[]) => {
      for (const text of texts) {
        // The same code is held before the camera for many frames.
        if (text === last) continue;
        last = text;
        const said = take.current(text);
        id++;
        const one = { ...said, id };
        setHeard((before) => [one, ...before].slice(0, MOST_HEARD));
      }
    };
    watch(video, wanted, end.signal, {
      onLive: (all) => {
        setState("live");
        setCameras(all);
      },
      onTexts: listen,
    }).catch((problem) => {
      if (!end.signal.aborted) setState({ problem: whyNot(problem) });
    });
    return () => end.abort();
  }, [wanted, tries]);

  const other = cameras[(cameras.indexOf(wanted ?? "") + 1) % Math.max(1, cameras.length)];
  const [latest] = heard;
  return (
    <Dialog
      title="Scan QR codes"
      about="Hold one telephone after the other before the camera. Pupils find their code on the sheet, under “Show QR code”."
      onClose={onClose}
    >
      <div class={css["scan"]}>
        {typeof state === "object" ? (
          <p role="alert" class={layout["missing"]}>
            {state.problem}
          </p>
        ) : (
          <video
            ref={video}
            class={css["camera"]}
            data-heard={latest ? (latest.problem ? "other" : "answers") : undefined}
            playsInline
            muted
            aria-label="What the camera sees"
          />
        )}
        {typeof state !== "object" && (
          <>
            <div class={css["count"]}>
              <strong class="number">{count}</strong>
              <label class={`${fieldCss["field"]} ${css["size"]}`}>
                Pupils in the class
                <input
                  type="number"
                  min={1}
                  max={999}
                  inputMode="numeric"
                  value={size ?? ""}
                  onInput={({ currentTarget }) => {
                    const value = Math.round(currentTarget.valueAsNumber);
                    onSize(value >= 1 && value <= 999 ? value : null);
                  }}
                />
              </label>
            </div>
            <p class={css["latest"]} role="status">
              {latest ? (
                <span key={latest.id} class={latest.problem ? layout["missing"] : undefined}>
                  {latest.words}
                </span>
              ) : state === "live" ? (
                "No code yet."
              ) : (
                "Asking for the camera. The browser may want you to allow it."
              )}
            </p>
          </>
        )}
        <div class={layout["buttons"]}>
          <Button kind={typeof state === "object" ? "plain" : "primary"} onClick={onClose}>
            Done
          </Button>
          {typeof state === "object" && <Button onClick={() => setTries(tries + 1)}>Try again</Button>}
          {cameras.length > 1 && other !== undefined && (
            <Button icon="swap" onClick={() => setWanted(other)}>
              Other camera
            </Button>
          )}
        </div>
        {heard.length > 1 && (
          <ol class={css["heard"]} aria-label="Before that">
            {heard.slice(1).map(({ id, words }) => (
              <li key={id}>{words}</li>
            ))}
          </ol>
        )}
      </div>
    </Dialog>
  );
}

interface Watching {
  /** The camera shows a picture; these are all that there are. */
  onLive: (cameras: string[]) => void;
  onTexts: (texts: readonly string[]) => void;
}

/** Shows a camera, and reads codes from it until it is called off. */
async function watch(
  video: { current: HTMLVideoElement | null },
  wanted: string | null,
  signal: AbortSignal,
  { onLive, onTexts }: Watching,
): Promise<void> {
  if (!navigator.mediaDevices?.getUserMedia) throw new DOMException("", "NotSupportedError");
  const media = await navigator.mediaDevices.getUserMedia({
    video: {
      width: { ideal: 1280 },
      height: { ideal: 720 },
      ...(wanted === null ? { facingMode: "environment" } : { deviceId: { exact: wanted } }),
    },
  });
  const stop = () => {
    for (const track of media.getTracks()) track.stop();
  };
  signal.addEventListener("abort", stop);
  let reader: CodeReader | null = null;
  try {
    const element = video.current;
    if (signal.aborted || !element) return;
    const lost = new Promise<never>((_, reject) => {
      for (const track of media.getTracks())
        track.addEventListener("ended", () => reject(new DOMException("", "NotReadableError")));
    });
    lost.catch(() => {});
    element.srcObject = media;
    await element.play();
    reader = new (await import("#workers/codes/client")).CodeReader();
    const all = await navigator.mediaDevices.enumerateDevices();
    if (signal.aborted) return;
    onLive(all.flatMap(({ kind, deviceId }) => (kind === "videoinput" && deviceId !== "" ? [deviceId] : [])));
    while (!signal.aborted) {
      const picture = await Promise.race([createImageBitmap(element), lost]);
      const texts = await reader.read(picture, "frame");
      if (!signal.aborted) onTexts(texts);
      await new Promise((done) => setTimeout(done, REST_MS));
    }
  } finally {
    stop();
    reader?.close();
  }
}

/** Why there is no camera, and what can be done. */
function whyNot(problem: unknown): string {
  const name = problem instanceof DOMException ? problem.name : "";
  const others = "Or let your class send links, and paste them here.";
  if (name === "NotAllowedError" || name === "SecurityError")
    return `The camera is not allowed for this page. Allow it beside the address of the page, and try again. ${others}`;
  if (name === "NotFoundError" || name === "OverconstrainedError")
    return `No camera was found. Connect one, and try again. ${others}`;
  if (name === "NotReadableError" || name === "AbortError")
    return `The camera gives no picture: another program may be using it. Close that program, and try again. ${others}`;
  if (name === "NotSupportedError")
    return `This browser gives no camera to this page; it does only where the address begins with https. ${others}`;
  return `The camera could not be used. ${problem instanceof Error ? problem.message : ""} ${others}`;
}
