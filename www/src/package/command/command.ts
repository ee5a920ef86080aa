/** The command `frond`: pictures, films, loci and answers without a browser. What the system gives is handed in. */
import { analyze } from "./analyze";
import { connectedness, distance, exported, locus } from "./answers";
import { certificate, check } from "./certificate";
import { render } from "./draw/render";
import * as help from "./help";
import { mesh } from "./mesh";
import { type Options, Refusal } from "./options";
import { fit, trace } from "./outline/curve";
import { plan } from "./plan";
import type { System } from "./system";

type Command = (subject: string, options: Options, system: System) => Promise<number>;

const COMMANDS: Readonly<Record<string, help.Words & { run: Command }>> = {
  render: { ...help.RENDER, run: render },
  locus: { ...help.LOCUS, run: locus },
  connectedness: { ...help.CONNECTEDNESS, run: connectedness },
  analyze: { ...help.ANALYZE, run: analyze },
  distance: { ...help.DISTANCE, run: distance },
  certificate: { ...help.CERTIFICATE, run: certificate },
  check: { ...help.CHECK, run: check },
  plan: { ...help.PLAN, run: plan },
  export: { ...help.EXPORT, run: exported },
  trace: { ...help.TRACE, run: trace },
  fit: { ...help.FIT, run: fit },
  mesh: { ...help.MESH, run: mesh },
};

/** All that can be said, and whether something stands after it, for whoever reads the words. */
export const OPTIONS: Readonly<Record<string, "string" | "boolean">> = Object.fromEntries(
  Object.values(COMMANDS)
    .flatMap(({ options }) => options)
    .map(([name, value]) => [name, value === null ? "boolean" : "string"] as const),
);

const named = (name: string) => (Object.hasOwn(COMMANDS, name) ? COMMANDS[name] : undefined);

/** Resolves to the exit code. */
export async function run(words: string[], options: Options, system: System): Promise<number> {
  const [command = "", subject] = words;
  if (options["version"]) {
    system.print(`frond-ifs ${system.version}`);
    return 0;
  }
  const asked = command === "help" ? (subject ?? "") : command;
  if (options["help"] || command === "help") {
    const about = named(asked);
    if (asked !== "" && !about) throw new Refusal(`There is no command "${asked}". See frond --help.`);
    system.print(about ? help.helpOn(asked, about) : help.helpOf(COMMANDS));
    return 0;
  }
  if (command === "") {
    system.tell(help.helpOf(COMMANDS));
    return 2;
  }
  const chosen = named(command);
  if (!chosen) throw new Refusal(`There is no command "${command}". See frond --help.`);
  if (!subject) throw new Refusal(`"frond ${command}" of what? See frond help ${command}.`);
  if (words.length > 2) throw new Refusal(`"${words[2]}" is one word too many. Put a link into quotes.`);
  const unknown = Object.keys(options).find((name) => !chosen.options.some(([known]) => known === name));
  if (unknown) throw new Refusal(`"frond ${command}" has no option --${unknown}. See frond help ${command}.`);
  if (options["out"] !== undefined) await system.writable(String(options["out"]));
  return chosen.run(subject, options, options["quiet"] ? silent(system) : system);
}

/** Says nothing of how it goes. */
function silent({ rewrite: _, ...system }: System): System {
  return { ...system, tell() {} };
}
