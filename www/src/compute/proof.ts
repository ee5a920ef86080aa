/** A proof that the shape on the stage is in one piece, or in several, and its replay. */
import { computed, effect, type ReadonlySignal, signal, untracked } from "@preact/signals";
import { shown } from "#document/morph";
import { wordsOf } from "#document/notice";
import { RESOLUTION, type Told } from "#format/verdict";
import type { Certificate, CertificateCheck, ConnectedCertificate, MapRow } from "#wasm/api";
import { cancel, epoch, submit } from "#workers/pool/engine";
import { single } from "#workers/pool/protocol";
import * as messages from "./messages";
import { verdict } from "./results";

/** A proof that the shape on the stage is in one piece, or in several. */
export type Proof =
  | { state: "asked"; maps: MapRow[] }
  | {
      state: "there";
      maps: MapRow[];
      certificate: Certificate | ConnectedCertificate;
      check: CertificateCheck;
      /** The formulas that entries mean; where there are none, it is about the doubles. */
      numbers?: readonly string[];
    }
  /** There is none to be had, or it could not be made: why, in words. */
  | { state: "none"; maps: MapRow[]; why: string };

const latest = signal<Proof | null>(null);

/** About the maps on the stage; null where it was not asked for. */
export const proof: ReadonlySignal<Proof | null> = computed(() =>
  latest.value?.maps === shown.value ? latest.value : null,
);

/** What is known of the shape on the stage, and whether the checker took a certificate of it. */
export const told: ReadonlySignal<Told | null> = computed(() => {
  const now = verdict.value;
  const found = proof.value;
  if (!now || now.stale || found?.state !== "there" || !found.check.valid) return now?.connectedness ?? null;
  const proved = "links" in found.certificate ? "connected" : "disconnected";
  if (proved !== now.connectedness.verdict) return now.connectedness;
  return { ...now.connectedness, checked: true };
});

/** Makes the proof and has it checked. */
export function prove(): void {
  const maps = shown.peek();
  const { closer, epsilon = RESOLUTION } = verdict.peek() ?? {};
  const connected = verdict.peek()?.connectedness.verdict === "connected";
  latest.value = { state: "asked", maps };
  const set = (found: Proof) => {
    if (latest.peek()?.maps === maps) latest.value = found;
  };
  void import("./exact")
    .then(({ proveMeant }) => proveMeant(epsilon))
    .catch(() => null)
    .then((exact) => {
      if (latest.peek()?.maps !== maps) return;
      if (exact && exact.state !== "undecided" && exact.check?.valid)
        set({
          state: "there",
          maps,
          certificate: exact.certificate,
          check: exact.check,
          numbers: exact.numbers,
        });
      else proveDoubles(maps, closer ?? epsilon, connected, set);
    });
}

function proveDoubles(
  maps: MapRow[],
  epsilon: number,
  connected: boolean,
  set: (found: Proof) => void,
): void {
  submit(
    single<"certificate">(
      "certificate",
      57,
      { kind: "certificate", maps, epsilon, connected },
      {
        accept: (found) =>
          set(
            found
              ? { state: "there", maps, ...found }
              : { state: "none", maps, why: messages.proofWouldNeedMore },
          ),
        fail: (error) => set({ state: "none", maps, why: wordsOf(error) }),
      },
    ),
  );
}

export function scheduleProof(): void {
  effect(() => {
    shown.value;
    epoch.value;
    untracked(() => {
      const now = latest.peek();
      if (!now || (proof.peek() && now.state !== "asked")) return;
      cancel("certificate");
      latest.value = null;
    });
  });
}
