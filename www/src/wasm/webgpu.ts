/**
 * Whether the browser has WebGPU: one that has the interface and no adapter behind it warns each time that it is asked.
 */
import { drawsOnCard, hasWebGpu } from "../../pkg/renderer.js";

const KEY = "frond-no-webgpu";

/** Asked once while the tab is open, over all pages of it; loading a page anew asks again. */
export async function lacksWebGpu(): Promise<boolean> {
  if (kept()) return true;
  const lacks = !(await hasWebGpu());
  if (lacks) keep();
  return lacks;
}

/** Whether the processor draws, whatever interface of a graphics card there is. */
export const drawsInSoftware = async (): Promise<boolean> => !(await drawsOnCard(await settled({})));

/** What a renderer is asked for, so that it need not ask the browser. */
export async function settled<Options extends { backend?: string }>(
  options: Options,
): Promise<Options | (Options & { backend: "webgl2" })> {
  const open = (options.backend ?? "auto") === "auto";
  return open && (await lacksWebGpu()) ? { ...options, backend: "webgl2" } : options;
}

function kept(): boolean {
  const [navigation] = performance.getEntriesByType("navigation") as PerformanceNavigationTiming[];
  if (navigation?.type === "reload") return false;
  try {
    return sessionStorage.getItem(KEY) !== null;
  } catch {
    // Storage may be switched off.
    return false;
  }
}

function keep(): void {
  try {
    sessionStorage.setItem(KEY, "");
  } catch {
    // The page keeps it as long as it is open.
  }
}
