/** What is said to the command, read with care. */

export type Options = Partial<Record<string, string | boolean>>;

/** What is asked for cannot be done: the command says why, and nothing else. */
export class Refusal extends Error {}

/** The name that stands for the standard input and the standard output. */
export const STANDARD = "-";

export function number(
  options: Options,
  name: string,
  least: number,
  most: number,
  otherwise: number,
): number {
  const text = options[name];
  if (text === undefined) return otherwise;
  const value = numberIn(text);
  if (!(value >= least && value <= most))
    throw new Refusal(`--${name} is a number from ${least} to ${most}, and not "${text}".`);
  return value;
}

/** NaN where it is none. */
const numberIn = (text: unknown): number =>
  typeof text === "string" && text.trim() !== "" ? Number(text) : Number.NaN;

export function whole(...args: Parameters<typeof number>): number {
  const [options, name, least, most] = args;
  const value = number(...args);
  if (!Number.isInteger(value))
    throw new Refusal(`--${name} is a whole number from ${least} to ${most}, and not "${options[name]}".`);
  return value;
}

/** --bounds: u0,u1,v0,v1. */
export function boundsOf({ bounds }: Options): { u0: number; u1: number; v0: number; v1: number } {
  if (bounds === undefined) return { u0: -1, u1: 2, v0: -1, v1: 2 };
  const numbers = String(bounds).split(",").map(numberIn);
  const [u0 = 0, u1 = 0, v0 = 0, v1 = 0] = numbers;
  const fits = numbers.length === 4 && numbers.every((x) => Math.abs(x) <= MOST_BOUND) && u0 < u1 && v0 < v1;
  if (!fits)
    throw new Refusal(
      `--bounds is u0,u1,v0,v1 with u0 < u1 and v0 < v1, none beyond ${MOST_BOUND}, as -1,2,-1,2, and not "${bounds}".`,
    );
  return { u0, u1, v0, v1 };
}

const MOST_BOUND = 1000;

export function outOf(options: Options): string {
  const out = options["out"];
  if (typeof out !== "string" || out === "")
    throw new Refusal("Where to? Say --out and the name of a file, or - for the standard output.");
  return out;
}

const endOf = (file: string) => /\.([a-z0-9]+)$/i.exec(file)?.[1]?.toLowerCase() ?? "";

/** What kind of file is asked for: by --as, or by how the name of --out ends. */
export function kindOf<Kind extends string>(
  options: Options,
  kinds: readonly Kind[],
  otherwise: Kind | null = null,
  advice = "",
): Kind {
  const named = (list: readonly string[]) => `${list.slice(0, -1).join(", ")} or ${list.at(-1)}`;
  const { as, out } = options;
  if (as !== undefined) {
    const kind = kinds.find((one) => one === as);
    if (kind === undefined) throw new Refusal(`--as is ${named(kinds)}, and not "${as}".${advice}`);
    return kind;
  }
  if (out === undefined || out === STANDARD) {
    if (otherwise !== null) return otherwise;
    if (out === undefined) outOf(options);
    throw new Refusal(`As what? Say --as and one of ${kinds.join(", ")}.`);
  }
  const end = endOf(String(out));
  const kind = kinds.find((one) => one === end);
  if (kind === undefined)
    throw new Refusal(`"${out}" is to end with ${named(kinds.map((one) => `.${one}`))}.${advice}`);
  return kind;
}

/** What is behind the shape, "#rrggbb"; null where it is left clear. */
export function groundOf(options: Options): string | null {
  const ground = options["background"];
  if (ground === undefined) return null;
  if (!/^#[0-9a-f]{6}$/i.test(String(ground))) throw new Refusal("--background is a colour such as #ffffff.");
  return String(ground);
}
