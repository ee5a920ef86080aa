import type { DirectedCertificate, DirectedFacts, DirectedMatch, StateConnectedness } from "#wasm/api";
import { wayWords } from "./words";

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
        What is in pieces itself can still be held together by what lies beside it.
      </p>
    );
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
      {match && match.states.length > 1 && (
        <p>
          On the way it has {match.states.length} states of its own, each made of one from either end: the
          ends may have more or fewer.
        </p>
      )}
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
        <p class="hint">
          {passing.length === 1 ? "State" : "States"} {passing.map((state) => state + 1).join(", ")} never{" "}
          {passing.length === 1 ? "comes back to itself" : "come back to themselves"}: a union of copies of
          other states, no more. To make it a fractal of its own, let a map copy it, or a state that is made
          of it.
        </p>
      )}
    </>
  );
}

function Unseen({ unreached }: { unreached: readonly number[] }) {
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
