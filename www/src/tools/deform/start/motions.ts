/** Motions to begin with: key frames of the mesh, made around a pose. */

import { movesAt } from "#document/deform/bend";
import { type Mesh, rest, rounder } from "#geometry/mesh";
import type { Deformation, DeformKey } from "#wasm/api";
import * as messages from "../messages";

export { rounder } from "#geometry/mesh";

type MotionId = "sway" | "breathe" | "wave" | "corner" | "still";

export interface Motion {
  id: MotionId;
  name: string;
  /** What it does, in a sentence. */
  about: string;
}

export const MOTIONS: readonly Motion[] = [
  { id: "sway", name: messages.sway, about: messages.upperRowsSwingBack },
  { id: "breathe", name: messages.breathe, about: messages.allPointsMoveOut },
  { id: "wave", name: messages.wave, about: messages.waveRunsAlongGrid },
  { id: "corner", name: messages.pullCorner, about: messages.upperRightCornerPulled },
  { id: "still", name: messages.still, about: messages.oneGridForAll },
];

type Sides = Pick<Mesh, "columns" | "rows" | "box">;
/** What lengths are measured by: the box, and the geometric mean of its sides. */
interface Lengths {
  width: number;
  height: number;
  size: number;
}
/** dx and dy at a place of the box, u and v from 0 to 1. */
type Gesture = (u: number, v: number, lengths: Lengths) => readonly [number, number];

interface Recipe {
  seconds: number;
  /** The moments of the keys, and what each adds to the pose. */
  keys: readonly { at: number; gesture: Gesture }[];
}

const STAY: Gesture = () => [0, 0];
const QUARTERS = [0, 0.25, 0.5, 0.75] as const;
const SWINGS = [0, 1, 0, -1] as const;

/** To one side, back, to the other side, back: the pose is met at 0 and half-way. */
function toAndFro(gesture: (swing: number) => Gesture): Recipe["keys"] {
  return QUARTERS.map((at, i) => ({ at, gesture: SWINGS[i] === 0 ? STAY : gesture(SWINGS[i] ?? 0) }));
}

const RECIPES: Record<Exclude<MotionId, "still">, Recipe> = {
  sway: {
    seconds: 4,
    // What leans over comes down a little, or it would grow.
    keys: toAndFro((s) => (_, v, { size }) => [0.28 * size * s * v * v, -0.04 * size * v * v]),
  },
  breathe: {
    seconds: 5,
    keys: toAndFro((s) => (u, v, { width, height }) => [
      0.24 * s * width * (u - 0.5),
      0.24 * s * height * (v - 0.5),
    ]),
  },
  wave: {
    seconds: 3,
    keys: Array.from({ length: 8 }, (_, i) => ({
      at: i / 8,
      gesture: (u, _, { size }) => [0, 0.18 * size * Math.sin(2 * Math.PI * (0.75 * u - i / 8))],
    })),
  },
  corner: {
    seconds: 4,
    keys: toAndFro((s) => (u, v, { size }) => {
      const far = (s > 0 ? 0.4 : -0.2) * size * (u * v) ** 3;
      return [far, far];
    }),
  },
};

/** What a motion moves around: the mesh itself while it stands still, else the middle of what it does now. */
export function poseOf({ keys, loop }: Pick<Deformation, "keys" | "loop">): number[] {
  const start = movesAt(keys, 0, loop);
  const half = movesAt(keys, 0.5, loop);
  return start.map((x, i) => (x + (half[i] ?? x)) / 2);
}

/** The key frames of a motion around a pose. */
export function keysOf(id: Exclude<MotionId, "still">, mesh: Sides, pose: readonly number[]): DeformKey[] {
  const { box } = mesh;
  const [width, height] = [box[2] - box[0], box[3] - box[1]];
  const lengths: Lengths = { width, height, size: Math.sqrt(width * height) };
  const round = rounder(Math.max(width, height));
  return RECIPES[id].keys.map(({ at, gesture }) => ({
    at,
    moves: Array.from({ length: mesh.columns * mesh.rows }, (_, i) => {
      const [x, y] = rest(mesh, i);
      const [dx, dy] = gesture((x - box[0]) / width, (y - box[1]) / height, lengths);
      return [round((pose[2 * i] ?? 0) + dx), round((pose[2 * i + 1] ?? 0) + dy)];
    }).flat(),
  }));
}

/** The deformation with this motion around its pose. It begins at the pose. */
export function withMotion(deformation: Deformation, id: MotionId): Deformation {
  if (id === "still") return stilled(deformation);
  const made: Deformation = {
    ...deformation,
    keys: keysOf(id, deformation, poseOf(deformation)),
    seconds: RECIPES[id].seconds,
    loop: true,
    phase: 0,
  };
  // Every leaflet sways about its own stem.
  return id === "sway" ? { ...made, spin: "scaled" } : made;
}

/** The mesh of this moment at all times. */
function stilled(deformation: Deformation): Deformation {
  const { keys, phase, loop } = deformation;
  if (keys.length === 1) return deformation;
  return { ...deformation, keys: [{ at: 0, moves: movesAt(keys, phase, loop) }], phase: 0 };
}

/** The motion that the keys are, if they are one of these. */
export function motionOf(deformation: Deformation): MotionId | null {
  const { keys, box } = deformation;
  if (keys.length === 1) return "still";
  const slight = 1e-4 * Math.max(box[2] - box[0], box[3] - box[1]);
  const pose = poseOf(deformation);
  for (const { id } of MOTIONS) {
    if (id === "still" || RECIPES[id].keys.length !== keys.length) continue;
    const same = keysOf(id, deformation, pose).every((key, k) => {
      const now = keys[k];
      return now?.at === key.at && key.moves.every((x, i) => Math.abs(x - (now.moves[i] ?? 0)) <= slight);
    });
    if (same) return id;
  }
  return null;
}
