/** A proof that the shape on the stage is in one piece, or in several, and its replay. */
import { computed, effect, type ReadonlySignal, signal, untracked } from "@preact/signals";
import { shown } from "#document/morph";
import type { Told } from "#format/verdict";
import type { Certificate, CertificateCheck, ConnectedCertificate, MapRow } from "#wasm/api";
import { cancel, epoch } from "#workers/pool/engine";
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

/** What was asked last; `prove.ts` fills it. */
export const latest = signal<Proof | null>(null);

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
