import type { DirectedCertificate, DirectedFacts, DirectedMatch, StateConnectedness } from "#wasm/api";
import * as messages from "./messages";
import { wayWords } from "./words";

/** What is known of the shape that is drawn. */
export function Answer({ of: state }: { of: StateConnectedness | undefined }) {
  const [link] = state?.links ?? [];
  if (!state || state.verdict === "disconnected") return null;
  if (state.verdict === "connected" && link) {
    return <p>{messages.sharedPoints(state.links.length, link.words[0], link.words[1])}</p>;
  }
  if (state.assuming.length > 0) {
    const more = state.assuming.length > 1 ? messages.andOthers : "";
    return <p>{messages.ifDecimals(state.assuming[0] ?? "", more)}</p>;
  }
  if (state.openBy.length > 0) {
    const names = state.openBy.map((k) => k + 1).join(", ");
    return <p>{messages.openStates(names)}</p>;
  }
  return null;
}

interface WayProps {
  proof: DirectedCertificate | null;
  match: DirectedMatch | null;
  /** The first moment that is known to be in pieces. */
  apart?: number | null;
  /** No proof is looked for any more. */
  ended?: boolean;
}

/** What is known of all of the way. */
export function Way({ match, proof, apart = null, ended = false }: WayProps) {
  return (
    <>
      {match?.steps.map((step) => (
        <p key={step}>{step}</p>
      ))}
      {match && match.states.length > 1 && <p>{messages.pairedStates(match.states.length)}</p>}
      {match && <p role="status">{wayWords({ proof, apart, ended })}</p>}
    </>
  );
}

/** States that the shape is not made of, and those to which no way leads back. */
export function Remarks({ unreached, neverReturn }: Pick<DirectedFacts, "unreached" | "neverReturn">) {
  // The shape itself often is a union of others, as the snowflake of its sides.
  const passing = neverReturn.filter((state) => state > 0 && !unreached.includes(state));
  return (
    <>
      <Unseen unreached={unreached} />
      {passing.length > 0 && (
        <p class="hint">{messages.neverReturn(passing.map((state) => String(state + 1)))}</p>
      )}
    </>
  );
}

function Unseen({ unreached }: { unreached: readonly number[] }) {
  if (unreached.length === 0) return null;
  return <p class="hint">{messages.unused(unreached.map((state) => String(state + 1)))}</p>;
}
