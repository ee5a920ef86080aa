/** What a command is about: a link, or what a file or the standard input holds. */
import { weighted } from "#geometry/maps/weighted";
import type { Ifs, MapRow3, Scene } from "#wasm/api";
import type { NamedMaps } from "./morph";
import { type Options, Refusal, STANDARD } from "./options";
import type { System } from "./system";

export interface Subject {
  scene: Scene;
  /** What stands before the # of the link. */
  page: string;
  /** The link as it came; null where it was none. */
  link: string | null;
  /** What a file of maps holds, to the last bit; absent of a link, of maps of space, and of several states. */
  maps?: NamedMaps;
}

/** A link that stands alone in a text: one line, with or without the address before its #. */
const LINK = /^(?:[^\s#]*#)?[a-z][a-z0-9-]*=\S*$/i;
/** So many colours a document has. */
const MOST_COLOURS = 64;
/** No link is longer. */
const MOST_LINK = 1 << 22;

/** Whether a word of the command is a link, and not the name of a file. */
const isLink = (word: string) => word.includes("=") && !/^[./]/.test(word);

export async function subjectOf(word: string, system: System): Promise<Subject> {
  if (isLink(word)) return fromLink(word, system);
  const bytes = await read(word, system);
  const text = textOf(bytes);
  if (text !== null && LINK.test(text)) return fromLink(text, system);
  const named = nameOf(word);
  const { importFile } = await system.exchange();
  const { systems, link } = importFile(bytes);
  const [first] = systems;
  if (!first) {
    if (link === undefined) throw new Refusal(`There are no maps in ${named}.`);
    return fromLink(link, system);
  }
  if (systems.length > 1) system.tell(`The first of ${systems.length} systems: ${first.name}`);
  if (first.problem !== undefined)
    throw new Refusal(`The maps of ${named} cannot be drawn: ${first.problem}`);
  const name = first.name || plainName(word);
  const { probabilities, colours } = first;
  const { defaultScene } = await system.draw();
  const { a: _a, b: _b, ...usual } = defaultScene();
  if (first.dimension === 3) {
    const { defaultSpace, packSpace } = await system.space();
    const all: MapRow3[][] = first.objects ?? [first.maps];
    const objects = all.map((maps, k) => ({ name: all.length > 1 ? `${name} ${k + 1}` : name, maps }));
    const packed = packSpace({ ...defaultSpace(), objects });
    const scene: Scene = { ...defaultScene(), tool: "space", space: { packed, at: 0 } };
    return { scene, page: "", link: null };
  }
  if (first.states) {
    const shape = { name, states: first.states };
    const scene = defaultScene();
    return { scene: { ...scene, t: 0, directed: { a: shape, b: shape } }, page: "", link: null };
  }
  const maps: Ifs["maps"] = first.maps;
  const shape = { name, maps, ...(probabilities ? { weights: probabilities } : {}) };
  const scene: Scene = {
    ...usual,
    a: shape,
    b: shape,
    path: { kind: "straight", points: [] },
    t: 0,
    ...(colours ? { palette: colours.slice(0, MOST_COLOURS) } : {}),
  };
  const exact = { ...weighted(maps, probabilities), name, ...(colours ? { colours } : {}) };
  return { scene, page: "", link: null, maps: exact };
}

/** The same, where only what is on the command line was meant to be a link. */
export async function sceneOf(word: string, system: System): Promise<Scene> {
  const { scene, maps } = await subjectOf(word, system);
  if (maps)
    throw new Refusal(`${nameOf(word)} holds one shape, and this needs two: say a link, as "a=fern&b=tree".`);
  return scene;
}

async function fromLink(link: string, system: System): Promise<Subject> {
  const { decodeScene } = await system.draw();
  const at = link.indexOf("#");
  const { scene, problem } = decodeScene(link.slice(at + 1));
  if (problem) throw new Refusal(`The link cannot be read: ${problem.message}`);
  return { scene, page: at < 0 ? "" : link.slice(0, at), link: at < 0 ? `#${link}` : link };
}

/** The bytes of a file; of what is neither a file nor a link it says what both look like. */
async function read(word: string, system: System): Promise<Uint8Array> {
  try {
    return await system.read(word);
  } catch (problem) {
    if ((problem as { code?: unknown }).code !== "ENOENT" || /[./\\]/.test(word)) throw problem;
    throw new Refusal(
      `"${word}" is neither a file nor a link. A link looks like "a=fern&b=tree", in quotes; - reads the standard input.`,
    );
  }
}

/** A short text; null of anything else. */
function textOf(bytes: Uint8Array): string | null {
  if (bytes.length > MOST_LINK || bytes.includes(0)) return null;
  return new TextDecoder().decode(bytes).trim();
}

/** What a file is called in a sentence. */
export const nameOf = (word: string) => (word === STANDARD ? "the standard input" : word);

/** The name of a shape after its file. */
export const plainName = (word: string) =>
  (word === STANDARD ? "shape" : word)
    .replace(/^.*[/\\]/, "")
    .replace(/\.[a-z0-9]+$/i, "")
    .slice(0, 60);

/** A file of maps stands still: it has no moments to choose from. */
export function noMoments({ maps }: Subject, options: Options): void {
  if (maps && options["t"] !== undefined) throw new Refusal("A file of maps has no moments: leave --t away.");
}
