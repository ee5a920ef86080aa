/**
 * How the values of a page stand in its address: each kind of value as a field that writes it and reads it back. What
 * an address says is not trusted: a field reads null where it could not have written it.
 */

export interface Field<T> {
  write(value: T): string;
  /** Null for anything that is no such value. */
  read(text: string): T | null;
}

const NUMBER = /^-?\d{1,9}(?:\.\d{1,12})?(?:e-\d{1,2})?$/;

/** A number of a range, to so many digits after the point. */
export function number(min: number, max: number, digits = 4): Field<number> {
  return {
    write: (value) => String(Number(value.toFixed(digits))),
    read(text) {
      const value = NUMBER.test(text) ? Number(text) : Number.NaN;
      // As fine as it is written, so that what is copied again is the same.
      return value >= min && value <= max ? Number(value.toFixed(digits)) : null;
    },
  };
}

/** A whole number of a range. */
export function whole(min: number, max: number): Field<number> {
  const { write, read } = number(min, max, 0);
  return { write, read: (text) => (/^-?\d+$/.test(text) ? read(text) : null) };
}

/** One of a few words. */
export function oneOf<T extends string>(words: readonly T[]): Field<T> {
  return { write: (value) => value, read: (text) => words.find((word) => word === text) ?? null };
}

/** A text that is wholly of this form: `/[123]{0,12}/`. */
export function text(form: RegExp): Field<string> {
  const whole = new RegExp(`^(?:${form.source})$`, form.flags);
  return { write: (value) => value, read: (text) => (whole.test(text) ? text : null) };
}

/** On or off. */
export const flag: Field<boolean> = {
  write: (value) => (value ? "1" : "0"),
  read: (text) => (text === "1" ? true : text === "0" ? false : null),
};

/** A value that may also be none, which is written as nothing. */
export function optional<T>({ write, read }: Field<T>): Field<T | null> {
  return { write: (value) => (value === null ? "" : write(value)), read };
}

/** What is more than of its kind. */
export function only<T>({ write, read }: Field<T>, is: (value: T) => boolean): Field<T> {
  return {
    write,
    read(text) {
      const value = read(text);
      return value !== null && is(value) ? value : null;
    },
  };
}

/** Several values of one kind, at least and at most so many; lists within lists part their values by another mark. */
export function list<T>(of: Field<T>, least: number, most: number, mark = ","): Field<readonly T[]> {
  return {
    write: (values) => values.map((value) => of.write(value)).join(mark),
    read(text) {
      const parts = text === "" ? [] : text.split(mark, most + 1);
      if (parts.length < least || parts.length > most) return null;
      const values = parts.map((part) => of.read(part));
      return values.some((value) => value === null) ? null : (values as T[]);
    },
  };
}

/** Two numbers of a square, as a point of it. */
export function point(min: number, max: number, digits = 4): Field<[number, number]> {
  const { write, read } = list(number(min, max, digits), 2, 2);
  return { write, read: (text) => read(text) as [number, number] | null };
}

/** What has several named values, in the order of their names here. */
export function parts<T extends object>(fields: { [K in keyof T]: Field<T[K]> }): Field<T> {
  const names = Object.keys(fields) as (keyof T)[];
  return {
    write: (value) => names.map((name) => fields[name].write(value[name])).join(","),
    read(text) {
      const texts = text.split(",", names.length + 1);
      if (texts.length !== names.length) return null;
      const values = names.map((name, i) => [name, fields[name].read(texts[i] ?? "")] as const);
      return values.some(([, value]) => value === null) ? null : (Object.fromEntries(values) as T);
    },
  };
}
