// Chooses the graphics interface: WebGPU, or WebGL2 where that is missing. Each has a module of its own, loaded when it
// is wanted.

const modules = {
  webgpu: () => import("./frond-webgpu.js"),
  webgl2: () => import("./frond-webgl2.js"),
};
const loading = {};

function load(backend) {
  loading[backend] ??= (async () => {
    const module = await modules[backend]();
    await module.default();
    return module.Renderer;
  })();
  // A download that failed may succeed the next time.
  loading[backend].catch(() => delete loading[backend]);
  return loading[backend];
}

/** Whether there is a WebGPU adapter: some browsers have the interface and no adapter behind it. */
async function hasWebGpu() {
  try {
    return Boolean(await globalThis.navigator?.gpu?.requestAdapter());
  } catch {
    return false;
  }
}

export async function createRenderer(canvas, options = {}) {
  const { backend: wanted = "auto" } = options;
  if (wanted === "webgpu" || (wanted === "auto" && (await hasWebGpu()))) {
    try {
      return await (await load("webgpu")).create(canvas, { ...options, backend: "webgpu" });
    } catch (problem) {
      if (wanted === "webgpu") throw problem;
    }
  }
  return (await load("webgl2")).create(canvas, { ...options, backend: "webgl2" });
}
