import { useState } from "preact/hooks";

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

export function usePrediction<T>(first: T | null): Prediction<T> {
  const [guess, setGuess] = useState(first);
  const [said, setSaid] = useState(false);
  const [shown, setShown] = useState(false);
  return {
    guess,
    said,
    shown,
    say(next) {
      if (shown) return;
      setGuess(() => next);
      setSaid(true);
    },
    show: () => setShown(true),
    again: () => setShown(false),
  };
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
