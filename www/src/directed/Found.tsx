import { resolutionWords } from "#format/verdict";
import type { DirectedCertificate, DirectedMatch, StateConnectedness } from "#wasm/api";

/** What is known of the shape that is drawn. */
export function Answer({ of: state }: { of: StateConnectedness | undefined }) {
  const [link] = state?.links ?? [];
  if (!state || state.verdict === "disconnected") return null;
  const points = `Its pieces share ${state.links.length === 1 ? "a point" : `${state.links.length} points`} that are checked without rounding`;
  if (state.verdict === "connected" && link) {
    return (
      <p>
        {points}: the first is reached by the maps {link.words[0]} and by {link.words[1]}. All that it is made
        of holds together in the same way, and so it is in one piece.
      </p>
    );
  }
  if (state.assuming.length > 0) {
    const more = state.assuming.length > 1 ? ", and others" : "";
    return (
      <p>
        It would be proved to be in one piece if its numbers were those that they come near:{" "}
        {state.assuming[0]}
        {more}.
      </p>
    );
  }
  if (state.openBy.length > 0) {
    const names = state.openBy.map((k) => k + 1).join(", ");
    return (
      <p>
        Its own pieces hold together, but some are copies of state {names}, which may not: so it stays open.
      </p>
    );
  }
  return null;
}

/** What is proved of all of the way. */
export function Way({ proof, match }: { proof: DirectedCertificate | null; match: DirectedMatch | null }) {
  return (
    <>
      {match?.steps.map((step) => (
        <p key={step}>{step}</p>
      ))}
      {match && <p role="status">{wayWords(proof)}</p>}
    </>
  );
}

function wayWords(proof: DirectedCertificate | null): string {
  const first = proof?.states[0];
  if (!proof || !first) return "Looking for a proof about every moment of the way …";
  const assuming = proof.assuming.length > 0 ? `, if ${proof.assuming[0]} and so on` : "";
  switch (first.kind) {
    case "connected":
      return `The shape is in one piece at every moment of the way, proved${assuming}: its pieces share points that never part.`;
    case "within":
      return `At every moment of the way its pieces, and theirs, are held together by gaps of at most ${resolutionWords(first.gap)} of their size. This was found at ${proof.moments} moments, with bounds of what changes between them.`;
    default:
      return `That it stays in one piece is shown up to t = ${first.at.toFixed(2)}, and not there.`;
  }
}

/** States that the shape is not made of. */
export function Remarks({ unreached }: { unreached: readonly number[] }) {
  if (unreached.length === 0) return null;
  const names = unreached.map((state) => state + 1).join(", ");
  const [are, them] = unreached.length === 1 ? ["it is", "it"] : ["they are", "them"];
  return (
    <p class="hint">
      The shape is not made of state {names}: {are} not seen in it. Let a map copy {them}, or leave {them}{" "}
      out.
    </p>
  );
}
