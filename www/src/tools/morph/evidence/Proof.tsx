import { type Proof as Proved, proof, prove } from "#compute/proof";
import { notify, wordsOf } from "#document/notice";
import { Button } from "#ui/controls/Button";
import { download } from "#ui/files/download";
import type { Certificate, ConnectedCertificate } from "#wasm/api";
import css from "./evidence.module.css";
import { checkWords } from "./words";

/** The proof that it is in one piece, or in several: made, checked, and given away when asked for. */
export function Proof({ connected }: { connected: boolean }) {
  const now = proof.value;
  return (
    <div class={css["evidence-proof"]}>
      {now?.state === "there" ? (
        <Button onClick={() => saveProof(now.certificate)}>Download the proof</Button>
      ) : (
        <Button disabled={now?.state === "asked"} onClick={prove}>
          Check the proof
        </Button>
      )}
      <p role="status">{proofWords(now, connected)}</p>
    </div>
  );
}

function proofWords(now: Proved | null, connected: boolean): string {
  switch (now?.state) {
    case "asked":
      return "Writing it down and checking it …";
    case "there":
      return checkWords(now.check);
    case "none":
      return `There is no proof to show. ${now.why}`;
    default:
      return connected
        ? "Every link between pieces, shown to hold."
        : "Every pair of pieces across the gap, shown to be apart.";
  }
}

function saveProof(certificate: Certificate | ConnectedCertificate): void {
  try {
    const blob = new Blob([`${JSON.stringify(certificate)}\n`], { type: "application/json" });
    download(blob, "frond-proof.json");
  } catch (problem) {
    notify({ kind: "error", text: `The proof could not be saved: ${wordsOf(problem)}` });
  }
}
