/** Pages that take scripts only from policies they know (`require-trusted-types-for 'script'`) know this one's name. */

interface Policy {
  createScriptURL(address: string): string;
}
interface Factory {
  createPolicy(name: string, rules: { createScriptURL(address: string): string }): Policy;
}

let policy: Policy | null | undefined;

/** The address of a script of one's own, as such a page wants it. */
export function trusted(address: string): string {
  policy ??= made();
  return policy ? policy.createScriptURL(address) : address;
}

/** Null where there are none, and where the page refuses the name: then it refuses the script as well. */
function made(): Policy | null {
  const factory = (globalThis as { trustedTypes?: Factory }).trustedTypes;
  try {
    return factory?.createPolicy("frond", { createScriptURL: own }) ?? null;
  } catch {
    return null;
  }
}

/** No script but what was made on this page. */
function own(address: string): string {
  if (address.startsWith("blob:")) return address;
  throw new TypeError("Frond starts no such script.");
}
