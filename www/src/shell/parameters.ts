import type { PainterBackend } from "../canvas/painter";

export interface Parameters {
  backend: "auto" | PainterBackend;
  /** How many workers; null for as many as the machine has room for. */
  workers: number | null;
}

const BACKENDS: readonly string[] = ["webgpu", "webgl2", "canvas"];

/** `?backend=webgl2`, `?workers=0`: for trying the page as another machine would run it. */
export function readParameters(search: string): Parameters {
  const query = new URLSearchParams(search);
  const backend = query.get("backend") ?? "";
  return {
    backend: BACKENDS.includes(backend) ? (backend as PainterBackend) : "auto",
    workers: /^[0-8]$/.test(query.get("workers") ?? "") ? Number(query.get("workers")) : null,
  };
}
