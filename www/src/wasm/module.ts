/** Fetches and compiles a module. */
export async function compiled(url: string): Promise<WebAssembly.Module> {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`The program could not be loaded (${response.status} for ${url}).`);
  // A static host may send wasm under another type, which the streaming compiler refuses.
  try {
    return await WebAssembly.compileStreaming(response.clone());
  } catch {
    return WebAssembly.compile(await response.arrayBuffer());
  }
}

/** Does it when first asked for, and again only if that failed: a download may succeed the next time. */
export function once<T>(get: () => Promise<T>): () => Promise<T> {
  let got: Promise<T> | null = null;
  return () => {
    got ??= get().catch((problem: unknown) => {
      got = null;
      throw problem;
    });
    return got;
  };
}
