// A worker of Node as browsers have them. An idle one does not keep a program from its end.
export function like(worker) {
  const made = {
    onmessage: null,
    onerror: null,
    postMessage(message, transfer) {
      if (message.type !== "stop") worker.ref();
      worker.postMessage(message, transfer);
    },
    terminate() {
      worker.terminate();
    },
  };
  worker.on("message", (data) => {
    if (data.type !== "progress") worker.unref();
    made.onmessage?.({ data });
  });
  const fail = (problem) => made.onerror?.(problem ?? {});
  worker.on("error", fail);
  worker.on("exit", () => fail());
  return made;
}
