/** Makes a proof of what is shown, and has it checked: first about exact numbers, where the maps mean some. */
import { shown } from "#document/morph";
import { wordsOf } from "#document/notice";
import { RESOLUTION } from "#format/verdict";
import { submit } from "#workers/pool/engine";
import { single } from "#workers/pool/protocol";
import { proveMeant } from "./exact";
import * as messages from "./messages";
import { latest, type Proof } from "./proof";
import { verdict } from "./results";

export function prove(): void {
  const maps = shown.peek();
  const { closer, epsilon = RESOLUTION, connectedness } = verdict.peek() ?? {};
  const connected = connectedness?.verdict === "connected";
  latest.value = { state: "asked", maps };
  const set = (found: Proof) => {
    if (latest.peek()?.maps === maps) latest.value = found;
  };
  void proveMeant(epsilon)
    .catch(() => null)
    .then((found) => {
      if (found && found.state !== "undecided" && found.check?.valid) {
        const { certificate, check, numbers } = found;
        set({ state: "there", maps, certificate, check, numbers });
        return;
      }
      if (latest.peek()?.maps !== maps) return;
      const task = { kind: "certificate", maps, epsilon: closer ?? epsilon, connected } as const;
      submit(
        single<"certificate">("certificate", 57, task, {
          accept: (made) =>
            set(
              made
                ? { state: "there", maps, ...made }
                : { state: "none", maps, why: messages.proofWouldNeedMore },
            ),
          fail: (error) => set({ state: "none", maps, why: wordsOf(error) }),
        }),
      );
    });
}
