/** What the command answers without a picture: loci, verdicts, and maps for other programs. */
import type { ExportFormat } from "#wasm/api";
import { morphOf, type NamedMaps, withColours } from "./morph";
import { boundsOf, kindOf, number, type Options, outOf, Refusal, STANDARD, whole } from "./options";
import { progress } from "./progress";
import { nameOf, noMoments, sceneOf, subjectOf } from "./subject";
import type { System } from "./system";

/** Relative to the diameter: gaps below it are none. */
export const epsilonOf = (options: Options) => number(options, "epsilon", 1e-12, 1, 1 / 600);

export async function locus(word: string, options: Options, system: System): Promise<number> {
  const out = outOf(options);
  const advice = " The map as a picture is saved in the studio.";
  const kind = kindOf(options, ["csv", "npy"], null, advice);
  const size = {
    width: whole(options, "width", 2, 4096, 301),
    height: whole(options, "height", 2, 4096, 301),
  };
  const bounds = boundsOf(options);
  const w = number(options, "w", -2, 2, 0);
  const epsilon = epsilonOf(options);
  const { ends, morph } = await morphOf(await sceneOf(word, system), system);
  const meter = progress(system);
  const asked = { ...morph, ...size, bounds, epsilon, ...(w === 0 ? {} : { w }) };
  const { state, gap } = await system
    .pool()
    .locus(...ends, asked, { onProgress: (share) => meter.say(share) });
  meter.end();
  const { locusCsv, locusNpy } = await system.exchange();
  await system.write(out, (kind === "csv" ? locusCsv : locusNpy)(bounds, size.width, state, gap));
  system.tell(`${out === STANDARD ? "Written" : out}: ${size.width} x ${size.height} samples`);
  return 0;
}

/** Maps of a file, or of a link at a moment. */
export async function mapsOf(word: string, options: Options, system: System): Promise<NamedMaps> {
  const subject = await subjectOf(word, system);
  noMoments(subject, options);
  const { scene, maps, link } = subject;
  if (maps) return maps;
  if (scene.tool === "space" && link === null)
    throw new Refusal(`${nameOf(word)} holds maps of space: open it in the studio, in Space.`);
  const { at } = await morphOf(scene, system);
  const [ifs] = await at([number(options, "t", 0, 1, scene.t)]);
  return withColours(ifs ?? { maps: [] }, `${scene.a.name} to ${scene.b.name}`, scene);
}

export async function connectedness(word: string, options: Options, system: System): Promise<number> {
  const epsilon = epsilonOf(options);
  const found = await system.pool().connectedness(await mapsOf(word, options, system), { epsilon });
  system.print(JSON.stringify(found, null, 2));
  return found.verdict === "connected" || found.verdict === "touching" ? 0 : 1;
}

/** Of the two shapes of a link. */
export async function distance(word: string, options: Options, system: System): Promise<number> {
  const tolerance = number(options, "tolerance", 1e-9, 1, 1e-4);
  const { a, b } = await sceneOf(word, system);
  const found = await system.pool().hausdorffDistance({ maps: a.maps }, { maps: b.maps }, { tolerance });
  system.print(JSON.stringify(found, null, 2));
  return 0;
}

export async function exported(word: string, options: Options, system: System): Promise<number> {
  const { exportFormats, exportMaps } = await system.exchange();
  const formats = exportFormats().map(({ id }) => id);
  const format = String(options["as"] ?? "") as ExportFormat;
  if (!formats.includes(format)) throw new Refusal(`--as is one of ${formats.join(", ")}.`);
  const text = exportMaps(await mapsOf(word, options, system), format);
  if (options["out"] === undefined) system.print(text);
  else await system.write(outOf(options), text);
  return 0;
}
