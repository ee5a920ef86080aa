/** A path between the two shapes of a link on which they stay in one piece. */
import { epsilonOf } from "./answers";
import { morphOf } from "./morph";
import { kindOf, type Options, Refusal, STANDARD, whole } from "./options";
import { subjectOf } from "./subject";
import type { System } from "./system";

export async function plan(word: string, options: Options, system: System): Promise<number> {
  const kind = kindOf(options, ["json", "link"], "json");
  const epsilon = epsilonOf(options);
  const axes = whole(options, "axes", 2, 3, 2) as 2 | 3;
  const { size: _ } = options;
  const size = options["size"] === undefined ? {} : { size: whole(options, "size", 16, 512, 0) };
  const { scene, page, maps } = await subjectOf(word, system);
  if (maps) throw new Refusal('A path is between two shapes: say a link, as "a=fern&b=tree".');
  const { ends, morph, draw } = await morphOf(scene, system);
  const found = await system.pool().planPath(...ends, { ...morph, ...size, epsilon, axes });
  const path = { kind: "drawn", points: found.points.slice(1, -1) } as const;
  const text =
    kind === "link" ? `${page}#${draw.encodeScene({ ...scene, path })}` : JSON.stringify(found, null, 2);
  await answer(text, options, system);
  if (!found.holds) system.tell(`The best path that was found breaks: its widest gap is ${found.gap}.`);
  return found.holds ? 0 : 1;
}

/** Text that is printed, unless it is to go into a file. */
export async function answer(text: string, { out }: Options, system: System): Promise<void> {
  if (out === undefined || out === STANDARD) system.print(text.trimEnd());
  else await system.write(String(out), text.endsWith("\n") ? text : `${text}\n`);
}
