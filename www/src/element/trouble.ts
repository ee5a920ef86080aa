/** What is thrown and rejected: an error that is told from others by its code, which stays the same over versions. */

export class FrondError extends Error {
  override readonly name = "FrondError";
  readonly code: string;

  constructor(code: string, message: string) {
    super(message);
    this.code = code;
  }
}

/** What was thrown, whatever it was, as such an error. */
export function errorOf(problem: unknown): FrondError {
  if (problem instanceof FrondError) return problem;
  const { code, message } = (problem ?? {}) as { code?: unknown; message?: unknown };
  return new FrondError(
    typeof code === "string" ? code : "failed",
    typeof message === "string" ? message : String(problem),
  );
}
