/** Where the module is that decides and proves: said by the page, brought along, or beside the script. */
import { FrondError } from "./trouble";
import { unpacked } from "./unpack";

/** What a page may say: an address of `frond-proof_bg.wasm`, or of `frond-proof.js` beside it, or the bytes. */
export type ProofSource = string | URL | BufferSource | WebAssembly.Module;

/** As workers get it: a script that they import, or the module for the bindings that they have. */
export type Proof = { script: string } | { module: WebAssembly.Module };

let said: ProofSource | null = null;
let saidProof: Promise<Proof> | null = null;
let bring: (() => Promise<string>) | null = null;
let brought: Promise<Proof> | null = null;

export const saidSource = (): ProofSource | null => said;

/** From the page: it comes before all else. Null takes it back. */
export function sayProof(source: unknown): void {
  if (source !== null && source !== undefined && !isSource(source))
    throw new FrondError("proof", "FrondView.proof is the address of frond-proof_bg.wasm, or its bytes.");
  said = source ?? null;
  saidProof = null;
}

/** From a build that has it in a file of its own. */
export function bringProof(from: () => Promise<string>): void {
  bring = from;
}

/** `base` is the folder of the script, or of the studio; null where nobody knows of one. */
export function proofFrom(base: string | null): Promise<Proof> {
  if (said !== null) {
    const source = said;
    saidProof ??= fromSource(source);
    return once(saidProof, () => {
      if (said === source) saidProof = null;
    });
  }
  const beside = base === null ? null : { script: `${base}frond-proof.js` };
  if (bring) {
    brought ??= bring().then(async (text) => ({ module: await WebAssembly.compile(await unpacked(text)) }));
    const known = once(brought, () => {
      brought = null;
    });
    return beside ? known.catch(() => beside) : known;
  }
  if (beside) return Promise.resolve(beside);
  return Promise.reject(
    new FrondError("no-proof", "Say where it is: FrondView.proof is the address of frond-proof_bg.wasm."),
  );
}

/** What could not be had may be there the next time. */
function once(found: Promise<Proof>, forget: () => void): Promise<Proof> {
  found.catch(forget);
  return found;
}

function isSource(value: unknown): value is ProofSource {
  return (
    (typeof value === "string" && value.trim() !== "") ||
    value instanceof URL ||
    value instanceof ArrayBuffer ||
    ArrayBuffer.isView(value) ||
    value instanceof WebAssembly.Module
  );
}

/** Chrome compiles no DataView, which is what notebooks give. */
function bytesOf(source: BufferSource): BufferSource {
  return ArrayBuffer.isView(source)
    ? new Uint8Array(source.buffer, source.byteOffset, source.byteLength)
    : source;
}

async function fromSource(source: ProofSource): Promise<Proof> {
  if (source instanceof WebAssembly.Module) return { module: source };
  if (typeof source !== "string" && !(source instanceof URL))
    return { module: await WebAssembly.compile(bytesOf(source)) };
  const address = new URL(source, document.baseURI);
  // Bundlers name files anew, so that all that is no module is taken for one that is compiled.
  if (/\.m?js$/.test(address.pathname)) return { script: address.href };
  const answer = await fetch(address);
  if (!answer.ok) throw new FrondError("no-proof", `There is no ${address.href}.`);
  return { module: await WebAssembly.compile(await answer.arrayBuffer()) };
}
