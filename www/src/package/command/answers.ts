/** What the command answers without a picture: loci, verdicts, checks of proofs, and maps for other programs. */
import { weighted } from "#geometry/maps/weighted";
import type { ExportFormat, Ifs } from "#wasm/api";
import { morphOf, type NamedMaps, opened, withColours } from "./morph";
import { endOf, number, type Options, outOf, Refusal, whole } from "./options";
import type { System } from "./system";

export async function locus(link: string, options: Options, system: System): Promise<number> {
  const out = outOf(options);
  const kind = endOf(out);
  if (kind !== "csv" && kind !== "npy")
    throw new Refusal(`"${out}" is to end with .csv or .npy. The map as a picture is saved in the studio.`);
  const { ends, morph } = await morphOf(await opened(link, system), system);
  const size = {
    width: whole(options, "width", 2, 4096, 301),
    height: whole(options, "height", 2, 4096, 301),
  };
  const bounds = { u0: -1, v0: -1, u1: 2, v1: 2 };
  let told = 0;
  const onProgress = (share: number) => {
    if (share - told < 0.1) return;
    told = share;
    system.tell(`${Math.round(100 * share)} %`);
  };
  const { state, gap } = await system.pool().locus(...ends, { ...morph, ...size, bounds }, { onProgress });
  const { locusCsv, locusNpy } = await system.exchange();
  await system.write(out, (kind === "csv" ? locusCsv : locusNpy)(bounds, size.width, state, gap));
  system.tell(`${out}: ${size.width} x ${size.height} samples`);
  return 0;
}

/** Maps of a file, or of a link at a moment. */
async function mapsOf(subject: string, options: Options, system: System): Promise<NamedMaps> {
  let link = subject;
  if (!subject.includes("=") || /^[./]/.test(subject)) {
    const { importFile } = await system.exchange();
    const { systems, link: inside } = importFile(await system.read(subject));
    const [first] = systems;
    if (first) {
      if (options["t"] !== undefined) throw new Refusal("A file of maps has no moments: leave --t away.");
      if (systems.length > 1) system.tell(`The first of ${systems.length} systems: ${first.name}`);
      if (first.maps.some((map) => map.length !== 6))
        throw new Refusal(`${subject} holds maps of space: open it in the studio, in Space.`);
      const { name, maps, probabilities, colours } = first;
      return { ...weighted(maps as Ifs["maps"], probabilities), name, ...(colours ? { colours } : {}) };
    }
    if (inside === undefined) throw new Refusal(`There are no maps in ${subject}.`);
    link = inside;
  }
  const { scene, at } = await morphOf(await opened(link, system), system);
  const [ifs] = await at([number(options, "t", 0, 1, scene.t)]);
  return withColours(ifs ?? { maps: [] }, `${scene.a.name} to ${scene.b.name}`, scene);
}

export async function connectedness(subject: string, options: Options, system: System): Promise<number> {
  const epsilon = number(options, "epsilon", 1e-12, 1, 1 / 600);
  const found = await system.pool().connectedness(await mapsOf(subject, options, system), { epsilon });
  system.print(JSON.stringify(found, null, 2));
  return found.verdict === "connected" || found.verdict === "touching" ? 0 : 1;
}

export async function check(file: string, _: Options, system: System): Promise<number> {
  const { checkCertificate } = await system.proof();
  const { valid, text } = checkCertificate(parsed(file, await system.read(file)));
  system.print(text);
  return valid ? 0 : 1;
}

export async function exported(subject: string, options: Options, system: System): Promise<number> {
  const { exportFormats, exportMaps } = await system.exchange();
  const formats = exportFormats().map(({ id }) => id);
  const format = String(options["as"] ?? "") as ExportFormat;
  if (!formats.includes(format)) throw new Refusal(`--as is one of ${formats.join(", ")}.`);
  const text = exportMaps(await mapsOf(subject, options, system), format);
  if (options["out"] === undefined) system.print(text);
  else await system.write(outOf(options), text);
  return 0;
}

function parsed(file: string, bytes: Uint8Array) {
  try {
    return JSON.parse(new TextDecoder().decode(bytes));
  } catch {
    throw new Refusal(`${file} is no JSON. A certificate is what the studio saves as a proof.`);
  }
}
