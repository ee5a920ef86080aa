import type { FrondError } from "./api";

/** Any thrown value as the error object that every function of the package promises. */
export function toError(problem: unknown): FrondError {
  if (typeof problem === "object" && problem !== null) {
    const { code, message } = problem as { code?: unknown; message?: unknown };
    const text = typeof message === "string" ? message : String(problem);
    return { code: typeof code === "string" ? code : "internal", message: text };
  }
  return { code: "internal", message: String(problem) };
}
