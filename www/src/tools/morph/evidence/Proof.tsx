import { type Proof as Proved, proof, prove } from "#compute/proof";
import { notify, wordsOf } from "#document/notice";
import { Button } from "#ui/controls/Button";
import { download } from "#ui/files/download";
import type { Certificate, ConnectedCertificate } from "#wasm/api";
import css from "./evidence.module.css";
import * as messages from "./messages";
import { checkWords } from "./words";

/** The proof that it is in one piece, or in several: made, checked, and given away when asked for. */
export function Proof({ connected }: { connected: boolean }) {
  const now = proof.value;
  return (
    <div class={css["evidence-proof"]}>
      {now?.state === "there" ? (
        <Button onClick={() => saveProof(now.certificate)}>{messages.downloadProof}</Button>
      ) : (
        <Button disabled={now?.state === "asked"} onClick={prove}>
          {messages.checkProof}
        </Button>
      )}
      <p role="status">{proofWords(now, connected)}</p>
    </div>
  );
}

function proofWords(now: Proved | null, connected: boolean): string {
  switch (now?.state) {
    case "asked":
      return messages.writingAndCheckingProof;
    case "there":
      return checkWords(now.check);
    case "none":
      return messages.noProof(now.why);
    default:
      return connected ? messages.checksEveryContactBetween : messages.checksAllPiecesOn;
  }
}

function saveProof(certificate: Certificate | ConnectedCertificate): void {
  try {
    const blob = new Blob([`${JSON.stringify(certificate)}\n`], { type: "application/json" });
    download(blob, "frond-proof.json");
  } catch (problem) {
    notify({ kind: "error", text: messages.proofFailed(wordsOf(problem)) });
  }
}
