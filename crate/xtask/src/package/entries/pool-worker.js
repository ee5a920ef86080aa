// A worker of the pool: each module is fetched when something of it is first asked for.
import { performerFrom } from "./pool-lanes.js";

const started = async (loading) => {
  const module = await loading;
  await module.default();
  return module;
};

const perform = performerFrom({
  draw: () => started(import("./frond.js")),
  proof: () => started(import("./frond-proof.js")),
  fit: () => started(import("./frond-fit.js")),
  space: () => started(import("./frond-space.js")),
})((answer, transfer) => postMessage(answer, { transfer }));

addEventListener("message", ({ data }) => perform(data));
