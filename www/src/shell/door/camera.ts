/** The view that a file has of its system, where Frond has such a view, too. */
import type { ImportedSystem, Point3, SpaceView } from "#wasm/api";
import * as messages from "./messages";

/** Turned by no more than this, in degrees, a view is taken as upright. */
const UPRIGHT_DEGREES = 3;

type Plane = NonNullable<Extract<ImportedSystem, { dimension: 2 }>["camera"]>;
type Solid = NonNullable<Extract<ImportedSystem, { dimension: 3 }>["camera"]>;

/** Where the plane is looked at: the middle, and how far around it. Null where the view is turned. */
export function planeView({ centre, radius, angle }: Plane): { x: number; y: number; radius: number } | null {
  const turned = Math.abs(angle - 360 * Math.round(angle / 360));
  const [x, y] = centre;
  return turned <= UPRIGHT_DEGREES && radius > 0 ? { x, y, radius } : null;
}

/** From where space is looked at. Null where the view is tilted to its side: in Frond z is upwards. */
export function solidView({ eye, target, up, field }: Solid): SpaceView | null {
  const away = minus(eye, target);
  const distance = Math.hypot(...away);
  const angle = (field * Math.PI) / 180;
  if (!(distance > 0 && angle > 0 && angle < Math.PI)) return null;
  const [x, y, z] = away;
  const tilt = Math.asin(Math.max(-1, Math.min(1, z / distance)));
  // Straight from above, what is above in the picture says how it is turned.
  const turn = Math.hypot(x, y) > 1e-9 * distance ? Math.atan2(x, -y) : Math.atan2(-up[0], up[1]);
  const above: Point3 = [-Math.sin(turn) * Math.sin(tilt), Math.cos(turn) * Math.sin(tilt), Math.cos(tilt)];
  const right: Point3 = [Math.cos(turn), Math.sin(turn), 0];
  const rolled = Math.atan2(dot(up, right), dot(up, above));
  if (!(Math.abs(rolled) <= (UPRIGHT_DEGREES * Math.PI) / 180)) return null;
  return { target, distance, turn, tilt, angle };
}

/** What is said where the view of a file cannot be taken. */
export function cameraWords(system: ImportedSystem): string[] {
  if (!system.camera) return [];
  const taken = system.dimension === 2 ? planeView(system.camera) : solidView(system.camera);
  return taken ? [] : [messages.viewNotKept];
}

const minus = (p: Point3, q: Point3): Point3 => [p[0] - q[0], p[1] - q[1], p[2] - q[2]];
const dot = (p: Point3, q: Point3) => p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
