/** A point of the plane, y up. */
export interface World {
  readonly space: "world";
  readonly x: number;
  readonly y: number;
}

/** A point of the stage in CSS pixels from its upper left corner, y down. */
export interface Screen {
  readonly space: "screen";
  readonly x: number;
  readonly y: number;
}

export interface View {
  /** World point in the middle of the stage. */
  x: number;
  y: number;
  /** CSS pixels a unit. */
  scale: number;
}

export interface Size {
  width: number;
  height: number;
}

const MOST_ZOOM = 1e12;
const LEAST_ZOOM = 1 / 64;

export function world(x: number, y: number): World {
  return { space: "world", x, y };
}

export function screen(x: number, y: number): Screen {
  return { space: "screen", x, y };
}

export function toScreen(p: World, v: View, size: Size): Screen {
  return screen(size.width / 2 + (p.x - v.x) * v.scale, size.height / 2 - (p.y - v.y) * v.scale);
}

export function toWorld(p: Screen, v: View, size: Size): World {
  return world(v.x + (p.x - size.width / 2) / v.scale, v.y - (p.y - size.height / 2) / v.scale);
}

/** The view moved so that the world follows the pointer by (dx, dy) CSS pixels. */
export function panned(v: View, dx: number, dy: number): View {
  return { ...v, x: v.x - dx / v.scale, y: v.y + dy / v.scale };
}

/** The view enlarged by a factor about a point of the stage, which stays where it is. */
export function zoomed(v: View, factor: number, about: Screen, size: Size, fitScale: number): View {
  const scale = Math.min(fitScale * MOST_ZOOM, Math.max(fitScale * LEAST_ZOOM, v.scale * factor));
  const fixed = toWorld(about, v, size);
  return {
    x: fixed.x - (about.x - size.width / 2) / scale,
    y: fixed.y + (about.y - size.height / 2) / scale,
    scale,
  };
}
