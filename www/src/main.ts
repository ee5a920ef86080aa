import "./style/tokens.css";
import "./style/base.css";
import "./style/layout.css";
import "./style/stage.css";
import "./style/print.css";
import { h, render } from "preact";
import { notify, wordsOf } from "./document/notice";
import { link } from "./shell/actions";
import { App, fetchAhead } from "./shell/app";
import { installHook } from "./shell/hook";
import { readParameters } from "./shell/parameters";
import { keepTranslationsTrue } from "./shell/translated";
import { reportTrouble, showFailure } from "./shell/trouble";
import { whenFirstPicture } from "./stage/first-picture";
import { adoptPath, watchAutomaticPath } from "./tools/morph/locus/path/automatic";
import { loadBends } from "./wasm/bend";
import { load } from "./wasm/core";
import { compileProof } from "./wasm/proof";
import { fetchPool, startEngine } from "./workers/pool/engine";

reportTrouble();
keepTranslationsTrue(document.body);

async function begin(root: HTMLElement): Promise<void> {
  // Before anything starts a worker.
  if (origin === "null") (await import("./workers/sandboxed")).allowWorkers();
  const parameters = readParameters(location.search);
  // Nothing can read the link yet. Where it seems to bend something, what does is fetched beside what reads it.
  if (/[#&](mesh=|tool=deform)/.test(location.hash)) loadBends().catch(() => {});
  const page = await load();
  // Under way while the first picture is drawn, which does without it. What goes wrong is told where it is waited for.
  const proof = compileProof();
  proof.catch(() => {});
  const schedules = import("./compute/start");
  schedules.catch(() => {});
  fetchPool().catch(() => {});
  link.open();
  link.watch();
  const { hash } = location;
  addEventListener("hashchange", () => link.follow());
  // Whoever leaves, by a link of the page or for good, finds the address up to date on the way back.
  addEventListener("click", () => link.flush(), { capture: true });
  addEventListener("pagehide", () => link.flush());
  installHook();

  root.textContent = "";
  // In a frame of another page there is less of it.
  const embedded = document.documentElement.dataset["page"] === "embed";
  const View = embedded ? (await import("./shell/embed/Embed")).Embed : App;
  render(h(View, { backend: parameters.backend }), root);
  await whenFirstPicture();
  await startEngine(
    { page, proof: await proof },
    { workers: parameters.workers },
    {
      inline: () => notify({ kind: "info", text: "Running without workers: everything works, but slower." }),
      failed: (problem) => notify({ kind: "error", text: wordsOf(problem) }),
    },
  );
  adoptPath();
  (await schedules).startSchedules({ card: parameters.card });
  watchAutomaticPath();
  fetchAhead();
  import("./shell/later").then(
    ({ beginLater }) => beginLater(hash, embedded, parameters.play),
    () => undefined,
  );
}

const root = document.getElementById("app");
if (root) begin(root).catch((problem) => showFailure(root, problem));
