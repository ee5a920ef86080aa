// Chooses the graphics interface: WebGPU, or WebGL2 where that is missing. Each has a module of its own, loaded when it
// is wanted. What computes needs WebGPU.

const modules = {
  webgpu: () => import("./frond-webgpu.js"),
  webgl2: () => import("./frond-webgl2.js"),
};
const loading = {};

function load(backend) {
  loading[backend] ??= (async () => {
    const module = await modules[backend]();
    await module.default();
    return module;
  })();
  // A download that failed may succeed the next time.
  loading[backend].catch(() => delete loading[backend]);
  return loading[backend];
}

let asked;

/**
 * The adapter of WebGPU: some browsers have the interface and none behind it, and warn of it on the console each time that
 * they are asked. So they are asked once, whoever wants to know.
 */
function adapter() {
  asked ??= (async () => {
    try {
      return (await globalThis.navigator?.gpu?.requestAdapter()) ?? undefined;
    } catch {
      return undefined;
    }
  })();
  return asked;
}

export const hasWebGpu = async () => (await adapter()) !== undefined;

const SOFTWARE = /swiftshader|llvmpipe|lavapipe|softpipe|software|basic render|\bwarp\b/i;

/** Whether the processor stands in for a graphics card, as far as the browser tells without a device. */
function isSoftware(adapter) {
  const info = adapter.info ?? {};
  const names = [info.vendor, info.architecture, info.device, info.description].join(" ");
  const fallback = info.isFallbackAdapter ?? adapter.isFallbackAdapter ?? false;
  return fallback || SOFTWARE.test(names);
}

/** Whether WebGL2 is a graphics card's. */
function hasWebGlCard() {
  const { OffscreenCanvas, document } = globalThis;
  const canvas = OffscreenCanvas ? new OffscreenCanvas(1, 1) : document?.createElement("canvas");
  // Browsers that know of such a caveat give no context on the processor.
  const context = canvas?.getContext("webgl2", { failIfMajorPerformanceCaveat: true });
  if (!context) return false;
  const named = context.getExtension("WEBGL_debug_renderer_info")?.UNMASKED_RENDERER_WEBGL;
  const name = String(context.getParameter(named ?? context.RENDERER));
  context.getExtension("WEBGL_lose_context")?.loseContext();
  return !SOFTWARE.test(name);
}

let webGlCard;

export async function drawsOnCard({ backend = "auto" } = {}) {
  if (backend !== "webgl2" && (await hasGraphicsCard())) return true;
  if (backend === "webgpu") return false;
  webGlCard ??= hasWebGlCard();
  return webGlCard;
}

export async function hasGraphicsCard() {
  const found = await adapter();
  return found !== undefined && !isSoftware(found);
}

async function create(name, canvas, options) {
  const { backend: wanted = "auto" } = options;
  if (wanted === "webgpu" || (wanted === "auto" && (await adapter()))) {
    try {
      return await (await load("webgpu"))[name].create(canvas, { ...options, backend: "webgpu" });
    } catch (problem) {
      if (wanted === "webgpu") throw problem;
    }
  }
  return (await load("webgl2"))[name].create(canvas, { ...options, backend: "webgl2" });
}

export const createRenderer = (canvas, options = {}) => create("Renderer", canvas, options);

export const createSpaceRenderer = (canvas, options = {}) => create("SpaceRenderer", canvas, options);

export async function createLocusCompute({ software = false } = {}) {
  // Before anything is loaded or opened: a device on the processor would take time from the page.
  if (!(await (software ? hasWebGpu() : hasGraphicsCard()))) return undefined;
  let compute;
  try {
    compute = await (await load("webgpu")).LocusCompute.create();
  } catch {
    return undefined;
  }
  if (compute.software && !software) {
    compute.free();
    return undefined;
  }
  return compute;
}

// The morph that is timed: the dragon as three maps to the gasket.
const dragon = {
  maps: [
    [0.5, -0.5, 0.5, 0.5, 0, 0],
    [-0.5, 0, 0, -0.5, 1, 0],
    [0, 0.5, -0.5, 0, 0.5, 0.5],
  ],
};
const gasket = {
  maps: [
    [0.5, 0, 0, 0.5, 0, 0],
    [0.5, 0, 0, 0.5, 0.5, 0],
    [0.5, 0, 0, 0.5, 0.25, 0.433],
  ],
};

export async function timeLocus(compute, cpu, options = {}) {
  const { from = dragon, to = gasket, size = 128, epsilon = 1 / 600 } = options;
  const sampling = { width: size, height: size, epsilon };
  if (compute.software) return { faster: "cpu", gpu: Infinity, cpu: 0 };
  // The first run compiles the shader.
  await compute.run(from, to, { ...sampling, width: 8, height: 8 });
  await cpu(from, to, { ...sampling, width: 8, height: 8 });
  const { milliseconds, left } = await compute.run(from, to, sampling);
  const start = performance.now();
  await cpu(from, to, sampling);
  const cpuTime = performance.now() - start;
  // What is left is for the processor, and the hardest.
  const gpu = milliseconds + (4 * cpuTime * left) / (size * size);
  return { faster: gpu < cpuTime ? "gpu" : "cpu", gpu, cpu: cpuTime };
}
