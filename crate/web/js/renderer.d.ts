import type { Renderer, SpaceRenderer } from "./frond-webgl2.js";
import type { LocusCompute } from "./frond-webgpu.js";

export type { Renderer, SpaceRenderer } from "./frond-webgl2.js";
export type { LocusCompute } from "./frond-webgpu.js";

export interface RendererOptions {
  /** Default `auto`: WebGPU, or WebGL2 where that is missing. */
  backend?: "auto" | "webgpu" | "webgl2";
  /** Called once if the device or the context is lost: the canvas is of no use any more then. */
  onLost?: (reason: string) => void;
}

/**
 * Whether there is WebGPU. The browser is asked once, here or by what is below: one that has none warns each time on
 * the console. To spare even that, give `backend: "webgl2"`.
 */
export function hasWebGpu(): Promise<boolean>;

/** Whether WebGPU is a graphics card's, as far as the browser tells: not where the processor stands in for one. */
export function hasGraphicsCard(): Promise<boolean>;

/**
 * Whether one of the interfaces that `createRenderer` may use is a graphics card's. Where the processor stands in for
 * one, or there is neither, `rasterize(.., { draft: true })` in a worker draws what moves sooner than a `Renderer`.
 */
export function drawsOnCard(options?: Pick<RendererOptions, "backend">): Promise<boolean>;

/**
 * A live picture on a canvas that has had no context yet. Rejects with a FrondError where there is no graphics card.
 */
export function createRenderer(
  canvas: HTMLCanvasElement | OffscreenCanvas,
  options?: RendererOptions,
): Promise<Renderer>;

/** The same for space: what it is given is made by `SpacePicture` of the module `frond-space`. */
export function createSpaceRenderer(
  canvas: HTMLCanvasElement | OffscreenCanvas,
  options?: RendererOptions,
): Promise<SpaceRenderer>;

/**
 * A device that decides loci by WebGPU, on the page's thread or in a worker; `undefined` where there is none, or where
 * the processor stands in for a graphics card, unless `software` is true.
 */
export function createLocusCompute(options?: { software?: boolean }): Promise<LocusCompute | undefined>;

export interface LocusTimes {
  /** Which of the two is to be used. */
  faster: "gpu" | "cpu";
  /** Milliseconds of the graphics card, with what it leaves to the processor. */
  gpu: number;
  /** Milliseconds of the processor. */
  cpu: number;
}

type Maps = { maps: [number, number, number, number, number, number][] };

/**
 * Times one locus on the graphics card and by `cpu`, which is to do what `locus` does, on this thread or in workers. Do
 * it once, while nothing else is at work. The morph is that of a dragon to a gasket if none is given, 128 x 128
 * samples.
 */
export function timeLocus(
  compute: LocusCompute,
  cpu: (from: Maps, to: Maps, options: { width: number; height: number; epsilon: number }) => unknown,
  options?: { from?: Maps; to?: Maps; size?: number; epsilon?: number },
): Promise<LocusTimes>;
