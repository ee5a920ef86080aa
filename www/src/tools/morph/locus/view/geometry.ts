/** Views, windows and places, as functions. */

import { clampedView, type Family, homeOf } from "#compute/locus/window";
import type { Uv } from "#geometry/path";
import type { Bounds, LocusView } from "#wasm/api";

/** All of a plane. */
export function wholeOf(family: Family, sides = 2): LocusView {
  const { u0, v0, u1, v1 } = homeOf(family);
  return { family, sides, x: (u0 + u1) / 2, y: (v0 + v1) / 2, zoom: 1, w: 0 };
}

/** Decimals that tell the pixels of a window apart, and some more for what is kept. */
export const digitsOf = (zoom: number): number => 2 + Math.ceil(Math.log10(Math.max(1, zoom)));
export const kept = (x: number, zoom: number): number =>
  Number(x.toFixed(Math.min(20, digitsOf(zoom) + 2))) || 0;

/** Short in a link, and still finer than a pixel. */
export function roundedTo({ x, y, zoom, w, ...rest }: LocusView): LocusView {
  return { ...rest, x: kept(x, zoom), y: kept(y, zoom), zoom: Number(zoom.toPrecision(6)), w: kept(w, 100) };
}

/** Nearer by a factor; what is at a place of the square, in parts from its left and its bottom, stays there. */
export function zoomed(now: LocusView, factor: number, [px, py]: readonly [number, number]): LocusView {
  const zoom = clampedView({ ...now, zoom: now.zoom * factor }).zoom;
  const home = homeOf(now.family);
  // The middle moves by what the window loses on that side. Written so, it is exact for a factor of 1.
  const by = (home.u1 - home.u0) * (1 / now.zoom - 1 / zoom);
  return { ...now, zoom, x: now.x + (px - 0.5) * by, y: now.y + (py - 0.5) * by };
}

/** The view on the way from one to another: zoom evenly, about the one point that both have at the same place. */
export function between(from: LocusView, to: LocusView, s: number): LocusView {
  if (s >= 1) return to;
  const zoom = from.zoom * (to.zoom / from.zoom) ** s;
  const span = 1 / from.zoom - 1 / to.zoom;
  // As zoom goes, so goes the middle; where the zoom stays, evenly.
  const k = Math.abs(span) < 1e-9 / to.zoom ? s : (1 / from.zoom - 1 / zoom) / span;
  return { ...to, zoom, x: from.x + k * (to.x - from.x), y: from.y + k * (to.y - from.y) };
}

/** Round numbers of a window, about so many, and the decimals that tell them apart. */
export function ticksOf(low: number, high: number, count = 4): { at: number[]; digits: number } {
  const rough = (high - low) / count;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((k) => k * power).find((s) => s >= rough * 0.99) ?? rough;
  const digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  const at: number[] = [];
  const first = Math.ceil(low / step - 1e-9);
  for (let k = first; k * step <= high + 1e-9 * step && at.length < 9; k++)
    at.push(Number((k * step).toFixed(Math.min(20, digits))));
  return { at, digits };
}

/** More decimals than these are not written at every tick. */
const MOST_DECIMALS = 3;

/** What the ticks of a window are counted from, where their numbers would be too long. */
export interface Origin {
  /** A round number near the middle. */
  at: number;
  digits: number;
  /** What they are counted in: a power of ten. */
  unit: number;
}

/** Where ticks of so many decimals are counted from; null where they are short enough to be written out. */
export function originOf(low: number, high: number, digits: number): Origin | null {
  if (digits <= MOST_DECIMALS) return null;
  // One decimal less than the ticks have: it stays where it is when one moves a little.
  return {
    at: Number(((low + high) / 2).toFixed(Math.min(20, digits - 1))),
    digits: digits - 1,
    unit: 10 ** -digits,
  };
}

/** A tick as it is counted. */
export const countOf = (x: number, { at, unit }: Origin): number => Math.round((x - at) / unit) || 0;

/** Between a card and what it is about, in CSS pixels. */
const APART = 14;

interface Extent {
  width: number;
  height: number;
}

/**
 * Where the card stands: left of the square where there is room, since nothing is hidden there; else over the point,
 * well clear of a finger; always within the page.
 */
export function spot(
  at: { x: number; y: number },
  square: { left: number; right: number },
  card: Extent,
  page: Extent,
  finger: boolean,
): { left: number; top: number } {
  const within = (x: number, most: number) => Math.min(Math.max(8, x), Math.max(8, most - 8));
  const beside = square.left - APART - card.width;
  if (beside >= 8) return { left: beside, top: within(at.y - card.height / 2, page.height - card.height) };
  const clear = finger ? 48 : APART;
  const above = at.y - clear - card.height;
  const left = within(at.x - card.width / 2, page.width - card.width);
  if (above >= 8) return { left, top: above };
  return { left, top: within(at.y + clear, page.height - card.height) };
}

/** Pieces of an arc across a window: straight, to the eye. */
const PIECES = 96;

/** The part of a circle about 0 that comes near to a window, as points; null where none does. */
export function arcNear(radius: number, { u0, v0, u1, v1 }: Bounds): Uv[] | null {
  const [cx, cy] = [(u0 + u1) / 2, (v0 + v1) / 2];
  const reach = Math.hypot(u1 - u0, v1 - v0) / 2;
  const far = Math.hypot(cx, cy);
  if (Math.abs(far - radius) > reach) return null;
  const middle = Math.atan2(cy, cx);
  const half = reach >= radius / 2 ? Math.PI : Math.min(Math.PI, (1.2 * reach) / radius);
  return Array.from({ length: PIECES + 1 }, (_, k) => {
    const angle = middle + half * ((2 * k) / PIECES - 1);
    return [radius * Math.cos(angle), radius * Math.sin(angle)];
  });
}
