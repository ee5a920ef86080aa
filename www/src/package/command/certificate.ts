/** Proofs, and their replay. */
import { weighted } from "#geometry/maps/weighted";
import { pointsOf } from "#geometry/path";
import type { CertificateCheck, Ifs, MorphOptions, PathCertificate, PathPoint } from "#wasm/api";
import { epsilonOf, mapsOf } from "./answers";
import { morphOf } from "./morph";
import { type Options, Refusal } from "./options";
import { answer } from "./plan";
import { nameOf, sceneOf } from "./subject";
import type { System } from "./system";

/** What is proved of a path, with all that it takes to prove it again. */
interface PathProof {
  kind: "path";
  from: Ifs;
  to: Ifs;
  morph: MorphOptions;
  points: PathPoint[];
  within: number;
  proved: PathCertificate;
}

type Certify = (word: string, options: Options, system: System) => Promise<object | null>;
const KINDS: Readonly<Record<string, Certify>> = { one: inOnePiece, several: inSeveral, path: ofPath };

const NONE =
  "No proof was found. Where one is, it takes more pieces than Frond looks at, or is about what the numbers stand for.";

export async function certificate(word: string, options: Options, system: System): Promise<number> {
  const { of } = options;
  if (of !== undefined && !Object.hasOwn(KINDS, String(of)))
    throw new Refusal(`--of is one, several or path, and not "${of}".`);
  const certify = of === undefined ? whichever : (KINDS[String(of)] as Certify);
  const proof = await certify(word, options, system);
  if (proof === null) {
    system.tell(NONE);
    return 1;
  }
  await answer(JSON.stringify(proof), options, system);
  return 0;
}

async function whichever(word: string, options: Options, system: System) {
  const ifs = bare(await mapsOf(word, options, system));
  const epsilon = epsilonOf(options);
  const pool = system.pool();
  const { verdict } = await pool.connectedness(ifs, { epsilon });
  if (verdict === "disconnected") return pool.certificate(ifs, { epsilon });
  return verdict === "connected" ? pool.connectedCertificate(ifs, { epsilon }) : null;
}

async function inOnePiece(word: string, options: Options, system: System) {
  return system.pool().connectedCertificate(bare(await mapsOf(word, options, system)), {
    epsilon: epsilonOf(options),
  });
}

async function inSeveral(word: string, options: Options, system: System) {
  return system
    .pool()
    .certificate(bare(await mapsOf(word, options, system)), { epsilon: epsilonOf(options) });
}

const bare = ({ maps, probabilities }: Ifs): Ifs => weighted(maps, probabilities);

async function ofPath(word: string, options: Options, system: System): Promise<PathProof | null> {
  if (options["t"] !== undefined) throw new Refusal("A path has no --t: the proof is of all of it.");
  const within = epsilonOf(options);
  const { ends, morph, planned } = await morphOf(await sceneOf(word, system), system);
  const points = pointsOf(await planned()) as PathPoint[];
  const [from, to] = ends;
  const proved = await system.pool().certifyPath(from, to, points, { ...morph, within });
  if (!Number.isFinite(proved.gap)) return null;
  if (!proved.holds)
    system.tell(`Proved is only that no gap is wider than ${proved.gap}, and not ${within} as was asked.`);
  return proved.holds ? { kind: "path", from, to, morph, points, within, proved } : null;
}

export async function check(file: string, _: Options, system: System): Promise<number> {
  const proof = parsed(nameOf(file), await system.read(file));
  const { valid, text } = isPath(proof) ? await again(proof, system) : await replayed(proof, system);
  system.print(text);
  return valid ? 0 : 1;
}

async function replayed(proof: object, system: System): Promise<Pick<CertificateCheck, "valid" | "text">> {
  const { checkCertificate } = await system.proof();
  return checkCertificate(proof as Parameters<typeof checkCertificate>[0]);
}

const isPath = (proof: object): proof is PathProof => "kind" in proof && proof.kind === "path";

/** What is proved of a path is computed again: it has to come out no worse. */
async function again({ from, to, morph, points, within, proved }: PathProof, system: System) {
  const claimed = Number(proved?.gap);
  if (!(within > 0 && claimed >= 0)) return { valid: false, text: "This is no proof of a path." };
  const { gap, holds, boxes, joints } = await system
    .pool()
    .certifyPath(from, to, points, { ...morph, within });
  const by = joints > 0 ? `${joints} joints that stay joined` : `${boxes} boxes that cover it`;
  if (holds && gap <= claimed)
    return { valid: true, text: `No gap wider than ${gap} anywhere on the path: computed again, by ${by}.` };
  return {
    valid: false,
    text: `The path was claimed to have no gap wider than ${claimed}; proved is ${gap}.`,
  };
}

function parsed(named: string, bytes: Uint8Array): object {
  try {
    const value: unknown = JSON.parse(new TextDecoder().decode(bytes));
    if (typeof value === "object" && value !== null) return value;
  } catch {}
  throw new Refusal(
    `${named} is no JSON. A certificate is what the studio saves as a proof, or frond certificate.`,
  );
}
