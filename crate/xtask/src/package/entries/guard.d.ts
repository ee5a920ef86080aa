/** Every function throws one of these. Codes are stable, messages say what to do. */
export class FrondError extends Error {
  constructor(code: string, message: string, options?: { cause?: unknown });
  readonly code: string;
}

/**
 * What is taken where a `T` is asked for: lists of numbers need not be declared as rows of so many, and nothing that is
 * given is changed.
 */
export type Input<T> = T extends number | string | boolean | null | undefined
  ? T
  : T extends ArrayBufferView | ArrayBuffer | ((...args: never[]) => unknown) | EventTarget
    ? T
    : T extends readonly number[]
      ? readonly number[]
      : T extends readonly (infer Entry)[]
        ? readonly Input<Entry>[]
        : { readonly [Key in keyof T]: Input<T[Key]> };

declare global {
  interface SymbolConstructor {
    /** For `using`, where the language has it. */
    readonly dispose: unique symbol;
  }
}
