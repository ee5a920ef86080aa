/** Proofs, and their replay. */
import { type Options, Refusal } from "./options";
import { nameOf } from "./subject";
import type { System } from "./system";

export async function check(file: string, _: Options, system: System): Promise<number> {
  const { checkCertificate } = await system.proof();
  const proof = parsed(nameOf(file), await system.read(file));
  const { valid, text } = checkCertificate(proof as Parameters<typeof checkCertificate>[0]);
  system.print(text);
  return valid ? 0 : 1;
}

function parsed(named: string, bytes: Uint8Array): object {
  try {
    const value: unknown = JSON.parse(new TextDecoder().decode(bytes));
    if (typeof value === "object" && value !== null) return value;
  } catch {}
  throw new Refusal(`${named} is no JSON. A certificate is what the studio saves as a proof.`);
}
