/** The round: five steps on the real controls, and when somebody has done what a step asks for. */
import type { Scene } from "#wasm/api";

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
    title: "Press play",
    text: "A turns into B. The way between the two was chosen so that the shape stays in one piece.",
    target: ".time .play",
    done: (now, before) => now.playing || now.scene.t !== before.scene.t,
  },
  {
    title: "Now the straight way",
    text: "Choose Straight: the shortest way between the same two shapes. The time line below the picture marks where the shape falls apart.",
    target: PATH_KINDS,
    done: (now) => now.scene.path.kind === "straight",
  },
  {
    title: "The map says why",
    text: "Every point of it is a shape between A and B: in one piece where it is pale, and in pieces where it is dark. The straight line from A to B leads through the dark.",
    target: ".locus-square",
  },
  {
    title: "Go round",
    text: "Choose Auto, and a way round the dark is found. Or drag the way by its points.",
    target: PATH_KINDS,
    done: (now, before) => now.scene.path.kind !== "straight" && now.scene.path !== before.scene.path,
  },
  {
    title: "Ask why",
    text: "Here stands what is known of the shape at this moment. Press it: it tells why, and what is proved can be checked by another program.",
    target: '[data-testid="verdict"]',
    done: (now) => now.evidence,
  },
];
