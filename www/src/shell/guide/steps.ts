/** The round: five steps on the real controls, and when somebody has done what a step asks for. */
import type { Scene } from "#wasm/api";
import * as messages from "./messages";

/** What may be done in a step. */
export interface Doing {
  scene: Scene;
  playing: boolean;
  evidence: boolean;
}

export interface Step {
  title: string;
  text: string;
  /** The control that it is about. */
  target: string;
  /** Whether it is done, given how things stood when the step began; absent where looking is enough. */
  done?(now: Doing, before: Doing): boolean;
}

const PATH_KINDS = '[aria-labelledby="path-title"] [role="radiogroup"]';

export const STEPS: readonly Step[] = [
  {
    title: messages.pressPlay,
    text: messages.turnsIntoBFrond,
    target: ".time .play",
    done: (now, before) => now.playing || now.scene.t !== before.scene.t,
  },
  {
    title: messages.nowTryStraightPath,
    text: messages.chooseStraightShortestPath,
    target: PATH_KINDS,
    done: (now) => now.scene.path.kind === "straight",
  },
  {
    title: messages.locusShowsWhy,
    text: messages.everyPointShapeBetween,
    target: ".locus-square",
  },
  {
    title: messages.goAround,
    text: messages.chooseAutoAndFrond,
    target: PATH_KINDS,
    done: (now, before) => now.scene.path.kind !== "straight" && now.scene.path !== before.scene.path,
  },
  {
    title: messages.askWhy,
    text: messages.thisSaysWhatKnown,
    target: '[data-testid="verdict"]',
    done: (now) => now.evidence,
  },
];
