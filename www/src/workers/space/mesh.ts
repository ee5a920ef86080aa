import type { MeshFacts, MeshFormat, MeshOptions } from "#wasm/api";
import { type SpaceMeshHandle, solid } from "#wasm/space";
import type { Context } from "../lanes/task";
import type { Shown } from "./picture";

export interface MeshRequest {
  objects: Shown[];
  options: MeshOptions;
}

/** What is known of a mesh, and how many points its shape was covered with. */
export interface MeshMeasured extends MeshFacts {
  found: number;
}

export interface MeshFile {
  bytes: Uint8Array<ArrayBuffer>;
  facts: MeshMeasured;
}

const FIRST_POINTS = 20_000;
const LEAST_POINTS = 2_000;
/** Milliseconds from breath to breath. */
const BREATH = 40;

export const meshTasks = {
  /** How large a mesh is. */
  async meshFacts(context: Context<number>, request: MeshRequest): Promise<MeshMeasured> {
    const { mesh, facts } = await made(context, request);
    mesh.free();
    return facts;
  },

  /** A mesh as a file. Tells how many points were found. */
  async meshFile(
    context: Context<number>,
    { format, palette, ...request }: MeshRequest & { format: MeshFormat; palette: string[] },
  ): Promise<MeshFile> {
    const { mesh, facts } = await made(context, request);
    try {
      // Declared as what may be shared memory; it never is.
      const bytes = mesh.file(format, palette) as Uint8Array<ArrayBuffer>;
      context.transfer(bytes.buffer);
      return { bytes, facts };
    } finally {
      mesh.free();
    }
  },
};

/** In slices, so that a mesh that nobody wants any more is left unfinished. */
async function made(
  { breathe, progress }: Context<number>,
  { objects, options }: MeshRequest,
): Promise<{ mesh: SpaceMeshHandle; facts: MeshMeasured }> {
  const mesher = new solid.SpaceMesher(objects, options);
  let found = 0;
  try {
    for (let budget = FIRST_POINTS; ; ) {
      const before = performance.now();
      const done = mesher.run(Math.round(budget));
      found = mesher.found;
      progress(found);
      await breathe();
      if (done) break;
      const took = Math.max(0.5, performance.now() - before);
      budget = Math.max(LEAST_POINTS, budget * Math.min(4, BREATH / took));
    }
  } catch (problem) {
    mesher.free();
    throw problem;
  }
  const mesh = mesher.finish();
  return { mesh, facts: { ...mesh.facts(), found } };
}
