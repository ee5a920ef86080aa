/** How much it will be, measured on this device. */
import { useEffect, useState } from "preact/hooks";
import { wordsOf } from "#document/notice";
import type { Repeat } from "#wasm/api";
import { painters } from "#workers/film/crew";
import { channels, layOn } from "#workers/film/opaque";
import { type Subject, sampling } from "#workers/film/subject";
import * as messages from "./messages";
import { frameCount, litPart, type Plan } from "./plan";

export interface Preview {
  image: ImageData | null;
  /** The part of it that shows something. */
  lit: number;
  /** Milliseconds for one pixel of it that is drawn. */
  cost: number | null;
  problem: string | null;
}

const NOTHING: Preview = { image: null, lit: 0.5, cost: null, problem: null };
const BOX = { width: 416, height: 234 };
/** So long after the last change, in milliseconds. */
const REST_MS = 200;

interface Shown {
  width: number;
  height: number;
  /** Seconds. */
  at: number;
  ground: string | null;
  clear: boolean;
  /** Missing: as by itself. */
  photograph?: boolean;
}

/** A moment, small. */
export function usePreview(
  subject: Subject | null,
  { width, height, at, clear, ground: own, photograph }: Shown,
): Preview {
  const [preview, setPreview] = useState(NOTHING);
  const ground = own ?? subject?.ground ?? "";
  useEffect(() => {
    if (!subject) return;
    const stop = new AbortController();
    const scale = Math.min(1, BOX.width / width, BOX.height / height);
    const size = {
      width: Math.max(1, Math.round(width * scale)),
      height: Math.max(1, Math.round(height * scale)),
    };
    const draw = async () => {
      const look = { ...size, smooth: false, ground, ...(photograph === undefined ? {} : { photograph }) };
      const drawer = subject.drawer(look, { alone: true });
      try {
        const picture = await drawer.frame(at, stop.signal);
        if (!picture) throw new Error(messages.thereNoPictureAt);
        const { data, took } = picture;
        const lit = litPart(data, channels(ground));
        if (!clear) layOn(data, ground);
        const cost = leastCost(subject, took / (size.width * size.height));
        setPreview({ image: new ImageData(data, size.width, size.height), lit, cost, problem: null });
      } catch (problem) {
        if (!stop.signal.aborted) setPreview({ ...NOTHING, problem: wordsOf(problem) });
      } finally {
        drawer.end();
      }
    };
    const timer = setTimeout(() => void draw(), REST_MS);
    return () => {
      clearTimeout(timer);
      stop.abort();
    };
  }, [subject, width, height, at, ground, clear, photograph]);
  return preview;
}

const costs = new Map<string, { cost: number; name: string }>();

/** What else the device had to do does not count. */
function leastCost({ id, name }: Subject, cost: number): number {
  const known = costs.get(id);
  const least = known?.name === name ? Math.min(cost, known.cost) : cost;
  costs.set(id, { cost: least, name });
  return least;
}

/** About how many seconds all frames take. */
export function secondsFor(subject: Subject, plan: Plan, loop: Repeat, cost: number): number {
  const { smooth, drawn: larger } = sampling(plan.samples);
  const drawn = plan.width * plan.height * larger ** 2 * (subject.choosesSmooth && smooth ? 4 : 1);
  // Colouring and writing take about as long again as a picture that is easily drawn.
  const each = 0.7 * cost * drawn + plan.width * plan.height * 4e-5;
  return (each * frameCount(plan, loop)) / painters(drawn) / 1000;
}
