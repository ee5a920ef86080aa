/** What is said to the command, read with care. */

export type Options = Partial<Record<string, string | boolean>>;

/** What is asked for cannot be done: the command says why, and nothing else. */
export class Refusal extends Error {}

export function number(
  options: Options,
  name: string,
  least: number,
  most: number,
  otherwise: number,
): number {
  const text = options[name];
  if (text === undefined) return otherwise;
  const value = Number(text);
  if (typeof text !== "string" || text.trim() === "" || !(value >= least && value <= most))
    throw new Refusal(`--${name} is a number from ${least} to ${most}, and not "${text}".`);
  return value;
}

export function whole(...args: Parameters<typeof number>): number {
  const [options, name, least, most] = args;
  const value = number(...args);
  if (!Number.isInteger(value))
    throw new Refusal(`--${name} is a whole number from ${least} to ${most}, and not "${options[name]}".`);
  return value;
}

export function outOf(options: Options): string {
  const out = options["out"];
  if (typeof out !== "string" || out === "") throw new Refusal("Where to? Say --out and the name of a file.");
  return out;
}

export const endOf = (file: string) => /\.([a-z0-9]+)$/i.exec(file)?.[1]?.toLowerCase() ?? "";

/** What is behind the shape, "#rrggbb"; null where it is left clear. */
export function groundOf(options: Options): string | null {
  const ground = options["background"];
  if (ground === undefined) return null;
  if (!/^#[0-9a-f]{6}$/i.test(String(ground))) throw new Refusal("--background is a colour such as #ffffff.");
  return String(ground);
}
