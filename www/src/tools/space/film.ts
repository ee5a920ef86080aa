/** What there is to film in space: its time line, which can be had as numbers, too. */
import { moment, space, spacePart, spaceView, timeline } from "#document/space/space";
import { frameCount, type Plan } from "#film/plan";
import { loop } from "#film/settings";
import type { Films, Numbers, Still } from "#film/subject";
import { isDark } from "#style/ground";
import { palette } from "#style/palette";
import { plainName } from "#ui/files/download";
import type { Repeat, Space, SpaceTimeline, SpaceView } from "#wasm/api";
import type { Subject } from "#workers/film/subject";
import { spaceTask } from "#workers/space/client";
import { spaceDrawer } from "#workers/space/drawer";
import { Frames, frameRecord } from "#workers/space/frames";
import * as messages from "./messages";
import { ground } from "./stage/sight";
import { stageSize } from "./stage/state";
import { fly } from "./time/flight/flight";
import { MOST_BYTES, savedText } from "./time/saved/saved";

export async function films(): Promise<Films> {
  const now = space.peek();
  const view = spaceView.peek();
  const line = timeline.peek();
  if (!now || !view || !line) {
    return {
      subjects: [],
      nothing: {
        words: messages.noAnimationYetSo,
        label: messages.flyThrough,
        disabled: !now,
        run: () => void fly("through"),
      },
    };
  }
  const subject = subjectOf(now, view, line);
  return { subjects: [{ ...subject, numbers: numbersOf(now, view) }] };
}

/** What the stage shows: the time line at its moment, seen as it is seen now. */
export async function still(): Promise<Still> {
  const now = space.peek();
  const view = spaceView.peek();
  if (!now || !view) throw new Error(messages.thereNothingToDraw);
  const line = timeline.peek() ?? { seconds: 1, loop: "once" as const };
  return {
    subject: subjectOf(now, view, line, true),
    at: moment.peek(),
    stage: stageSize.peek(),
    inStrips: false,
  };
}

function subjectOf(
  now: Space,
  view: SpaceView,
  { seconds, loop }: Pick<SpaceTimeline, "seconds" | "loop">,
  still = false,
): Subject {
  // A scene of several has no name.
  const name = now.objects.length === 1 ? (now.objects[0]?.name ?? "") : "";
  return {
    id: "space",
    label: messages.space,
    name: plainName(name, "space", 32),
    seconds,
    anyLength: false,
    loops: ["once", "round", "pingpong"],
    loop,
    // Keys say how fast it goes.
    easing: "linear",
    ground: ground.peek(),
    choosesSmooth: true,
    drawer: (look, how) =>
      spaceDrawer(look, how?.alone ?? false, {
        space: now,
        view,
        still,
        palette: palette(isDark(look.ground) ? "dark" : "light"),
      }),
  };
}

const KINDS: Numbers["kinds"] = [
  {
    value: "frames",
    label: messages.everyFrame,
    description: messages.parametersEachFrameFor,
  },
  { value: "keys", label: messages.shapesAndKeyframes, description: messages.smallFileForFrond },
];

const ABOUT: Numbers["about"] = {
  keys: messages.shapesLightAndKeyframes,
  frames: messages.forEachFrameTime,
};

function numbersOf(now: Space, view: SpaceView): Numbers {
  const { packed, at } = spacePart.peek();
  return {
    kinds: KINDS,
    about: ABOUT,
    mostBytes: MOST_BYTES,
    bytes: (plan, go) => (plan.kind === "frames" ? parametersBytes(now, view, plan, go) : null),
    async make(plan, times, signal, onDone) {
      if (plan.kind === "keys") {
        const bytes = new TextEncoder().encode(savedText({ packed, at, view, space: now }));
        return { bytes, type: "application/json", missing: 0 };
      }
      const about = { packed, at, loop: loop.peek(), fps: plan.fps, seconds: plan.to - plan.from };
      return spaceTask(
        "parameters",
        { space: now, view, times, ...about },
        { lane: 1, signal, onProgress: onDone },
      );
    },
  };
}

/** How many bytes the parameters of all frames are, from some of them; null where they cannot be told. */
function parametersBytes(now: Space, view: SpaceView, plan: Plan, go: Repeat): number | null {
  let frames: Frames | null = null;
  try {
    frames = new Frames(now);
    const tried = [0, 0.21, 0.43, 0.68, 1].map((part) => plan.from + part * (plan.to - plan.from));
    let bytes = 0;
    for (const time of tried) bytes += JSON.stringify(frameRecord(now, time, frames.at(time), view)).length;
    const head = spacePart.peek().packed.length + 300;
    return (bytes / tried.length + 2) * frameCount(plan, go) + head;
  } catch {
    return null;
  } finally {
    frames?.free();
  }
}
