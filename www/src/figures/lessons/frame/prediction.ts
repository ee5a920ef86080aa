import { useState } from "preact/hooks";
import { type Field, flag, oneOf } from "../../kit/state/fields";
import { useKept } from "../../kit/state/kept";
import { useValue } from "../../kit/workers";
import { inTime, paper } from "./handout/paper";

/** What somebody expects to see, and whether they have looked. */
export interface Prediction<T> {
  /** Null until there is one. */
  guess: T | null;
  /** Whether it was made: what a slider begins with is no guess. */
  said: boolean;
  shown: boolean;
  /** Changes the guess; once the truth is shown it stays as it was made. */
  say(guess: T): void;
  show(): void;
  /** Covers the truth again; the guess stays to be thought over. */
  again(): void;
}

/** `kept` says how a guess stands in the address of the lesson. */
export function usePrediction<T>(first: T | null, kept: Field<T>): Prediction<T> {
  const [made, make] = useKept<T | null>("guess", null, orNone(kept));
  const [shown, setShown] = useKept("shown", false, flag);
  const [begun] = useState(first);
  const guess = made ?? begun;
  const said = made !== null;
  const covered = useValue(paper);
  const drawn = useValue(inTime);
  return {
    // A number stays where its picture had no time to follow.
    guess: covered && (drawn || typeof guess !== "number") ? first : guess,
    said: said && !covered,
    // There is nothing to compare the truth with before a guess.
    shown: shown && said && !covered,
    say(next) {
      if (shown && said) return;
      make(() => next);
    },
    show: () => setShown(true),
    again: () => setShown(false),
  };
}

/** None is written as nothing. */
function orNone<T>(of: Field<T>): Field<T | null> {
  return { write: (value) => (value === null ? "" : of.write(value)), read: of.read };
}

/** How near a guessed number came, in plain words: no marks are given. */
export function nearWords(
  guess: number,
  truth: number,
  { close, fair }: { close: number; fair: number },
): string {
  const off = Math.abs(guess - truth);
  if (off <= close) return "You saw it.";
  if (off <= fair) return "You were near.";
  return guess < truth ? "It is more than you thought." : "It is less than you thought.";
}

/** One of a few options, none of which is chosen at first. */
export function useChoice<T extends string>(options: readonly { value: T }[]): Prediction<T> {
  return usePrediction<T>(null, oneOf(options.map(({ value }) => value)));
}
