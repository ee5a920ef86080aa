/** The command `frond`: pictures, films, loci and answers without a browser. What the system gives is handed in. */
import { check, connectedness, exported, locus } from "./answers";
import { type Options, Refusal } from "./options";
import { render } from "./render";
import type { System } from "./system";

const HELP = `frond: the studio without a browser

  frond render <link> --out x.png|svg|gif|apng|zip|mp4|webm
                                                    a picture, or a film; videos by ffmpeg, where it is
    --width 1200 --height 900 --background #ffffff  without a background it is clear
    --t 0.5                                         of one moment; without it that of the link
    --seconds 8 --fps 25                            of a film; a ZIP holds its frames as PNG
    --frames 200                                    so many frames; with x.png: x-0001.png, x-0002.png ..
    --ease in-out --hold 1                          starts and stops gently; stands still for 1 s more at each end
  frond locus <link> --out x.csv|npy                verdict and gap of every sample of (u, v)
    --width 301 --height 301
  frond connectedness <link|file>                   in one piece? As JSON
    --t 0.5 --epsilon 0.0001
  frond check <certificate.json>                    replays a proof that a shape is in one piece, or in several
  frond export <link|file> --as FORMAT              the maps, as other programs read them
    --out file --t 0.5

A link is one of the studio, or what stands behind its #: "a=fern&b=tree". Morphs, bends and space are drawn; --t goes
from 0, the beginning, to 1. A file holds maps: .ifs, .flame, .aifs, JSON, a table, or a PNG of Frond's.
Exit codes: 0 done, 1 the answer is no, 2 it could not be done.`;

type Command = (subject: string, options: Options, system: System) => Promise<number>;

/** What each command does, and which options it knows. */
const COMMANDS: Readonly<Record<string, readonly [run: Command, options: readonly string[]]>> = {
  render: [render, ["out", "width", "height", "background", "t", "seconds", "fps", "frames", "ease", "hold"]],
  locus: [locus, ["out", "width", "height"]],
  connectedness: [connectedness, ["t", "epsilon"]],
  check: [check, []],
  export: [exported, ["as", "out", "t"]],
};

/** All that can be said, for whoever reads the words. */
export const OPTIONS: readonly string[] = [
  ...new Set(Object.values(COMMANDS).flatMap(([, options]) => options)),
];

/** Resolves to the exit code. */
export async function run(words: string[], options: Options, system: System): Promise<number> {
  const [command = "", subject] = words;
  if (options["help"] || command === "help") {
    system.print(HELP);
    return 0;
  }
  if (command === "") {
    system.tell(HELP);
    return 2;
  }
  const chosen = Object.hasOwn(COMMANDS, command) ? COMMANDS[command] : undefined;
  if (!chosen) throw new Refusal(`There is no command "${command}". See frond --help.`);
  if (!subject) throw new Refusal(`"frond ${command}" of what? See frond --help.`);
  if (words.length > 2) throw new Refusal(`"${words[2]}" is one word too many. Put a link into quotes.`);
  const [does, known] = chosen;
  const unknown = Object.keys(options).find((name) => !known.includes(name));
  if (unknown) throw new Refusal(`"frond ${command}" has no option --${unknown}. See frond --help.`);
  if (options["out"] !== undefined) await system.writable(String(options["out"]));
  return does(subject, options, system);
}
