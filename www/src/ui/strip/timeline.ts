/** What moves in time: the same to the keys of every tool. */
import { addStep } from "#format/numbers";
import type { Command } from "../commands";
import * as messages from "../messages";

export interface Timeline {
  now(): number;
  /** Moments go from 0 to this. */
  length(): number;
  /** By hand: what plays stops. */
  seek(moment: number): void;
  /** Plays, or pauses. */
  toggle(): void;
  /** To the stop before or after. */
  step(by: 1 | -1): void;
  /** What these are called: "frame". */
  stop: string;
}

export function timeCommands(line: Timeline): Command[] {
  const scrub = (part: number) => (way: number) =>
    line.seek(addStep(line.now(), (way === 0 ? -part : part) * line.length()));
  return [
    {
      id: "play",
      label: messages.playOrPause,
      group: messages.time,
      keys: ["Space"],
      run: () => line.toggle(),
    },
    {
      id: "scrub",
      label: messages.backOrForwardBy,
      group: messages.time,
      keys: ["←", "→"],
      run: scrub(0.01),
    },
    {
      id: "scrub-finely",
      label: messages.backOrForwardBy0,
      group: messages.time,
      keys: ["Shift+←", "Shift+→"],
      run: scrub(0.001),
    },
    {
      id: "step",
      label: messages.toStop(line.stop),
      group: messages.time,
      keys: ["[", "]"],
      run: (way) => line.step(way === 0 ? -1 : 1),
    },
  ];
}
