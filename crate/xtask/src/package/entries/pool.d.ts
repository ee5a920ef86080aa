import type { SpaceCarve } from "./frond-space.js";

type Draw = typeof import("./frond.js");
type Proof = typeof import("./frond-proof.js");
type Fit = typeof import("./frond-fit.js");
type Space = typeof import("./frond-space.js");

/** What can be asked of a pool. */
type Functions = Pick<Draw, "attractor" | "rasterize"> &
  Pick<
    Proof,
    | "barnsleyTest"
    | "candidates"
    | "certificate"
    | "certifyPath"
    | "checkCertificate"
    | "checkPath"
    | "connectedCertificate"
    | "connectedness"
    | "hausdorffDistance"
    | "indexBuffer"
    | "locus"
    | "planPath"
    | "rateCandidate"
    | "routes"
    | "ways"
  > &
  Pick<Fit, "fitCurve" | "fitWithin" | "houghMaps" | "rivalFit" | "rivalWithin" | "traceOutline"> &
  Pick<Space, "attractor3" | "boxes3" | "checkPath3" | "connectedness3" | "facts3" | "findPath3">;

export { FrondError } from "./guard.js";

export interface How {
  /** Calls it off: the promise is rejected with the reason of the signal, at once. */
  signal?: AbortSignal;
  /** How much is done, 0 to 1: now and then of `locus`, `fitCurve` and `fitWithin`, of others at the end. */
  onProgress?: (share: number) => void;
}

/** What a picture of space is made of; `factor` x `factor` looks make each pixel, and the ground is not drawn. */
export interface Picture3 {
  objects: ConstructorParameters<Space["SpacePicture"]>[0];
  view: Parameters<InstanceType<Space["SpacePicture"]>["carve"]>[0];
  light: Parameters<SpaceCarve["paint"]>[0];
  look: Parameters<SpaceCarve["paint"]>[1];
}

/** The functions of the other entries as promises: the same arguments, and after all of them how. */
export type Pool = {
  [Name in keyof Functions]: (
    ...args: [...Parameters<Functions[Name]>, how?: How]
  ) => Promise<ReturnType<Functions[Name]>>;
} & {
  /** A complete picture of space: RGBA, straight alpha, row 0 on top. */
  rasterize3(picture: Picture3, how?: How): Promise<Uint8ClampedArray<ArrayBuffer>>;
  /** How many workers it has at most; they are started when first needed. */
  readonly size: number;
  /** Ends the workers. What is under way is rejected with `{ code: "stopped" }`. */
  close(): void;
};

/** Workers of their own, as many as the machine has cores if nothing is said. */
export function createPool(options?: { size?: number }): Pool;
