import type { PainterBackend } from "../canvas/painter";

export interface Parameters {
  backend: "auto" | PainterBackend;
  workers: boolean;
}

const BACKENDS: readonly string[] = ["webgpu", "webgl2", "canvas"];

/** `?backend=webgl2`, `?workers=0`: for trying the page as another machine would run it. */
export function readParameters(search: string): Parameters {
  const query = new URLSearchParams(search);
  const backend = query.get("backend") ?? "";
  return {
    backend: BACKENDS.includes(backend) ? (backend as PainterBackend) : "auto",
    workers: query.get("workers") !== "0",
  };
}
