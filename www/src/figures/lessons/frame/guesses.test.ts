import { expect, it, vi } from "vitest";
import {
  clearGuesses,
  guessesIn,
  guessOf,
  keepGuess,
  keepTruth,
  rightIn,
  rightOf,
  truthOf,
  truthWords,
} from "./guesses";

it("reads nothing but guesses of lessons", () => {
  expect([...guessesIn('{"e1":"0.45","e99999":"x","<b>":"y","e2":3}')]).toEqual([["e1", "0.45"]]);
  for (const text of [null, "", "[1", "null", "7", '"e1"']) expect(guessesIn(text).size).toBe(0);
  expect(guessesIn(JSON.stringify({ e1: "x".repeat(900) })).get("e1")?.length).toBe(160);
});

it("reads of each lesson whether its guess was right, and nothing else", () => {
  expect([...rightIn('{"e1":true,"e2":false,"e3":1,"<b>":true}')]).toEqual([
    ["e1", true],
    ["e2", false],
  ]);
  for (const text of [null, "", "[1", "null", "7"]) expect(rightIn(text).size).toBe(0);
});

it("keeps what is so beside the guess that was made before, and beside no other", () => {
  const kept = new Map<string, string>();
  vi.stubGlobal("localStorage", {
    getItem: (key: string) => kept.get(key) ?? null,
    setItem: (key: string, words: string) => kept.set(key, words),
    removeItem: (key: string) => kept.delete(key),
  });
  keepGuess("e1", "0.42");
  keepTruth("e1", "0.42", false, "0.4");
  // Whoever thinks again knows it by now.
  keepGuess("e1", "0.4");
  keepTruth("e1", "0.4", true, "0.4");
  expect([guessOf("e1"), rightOf("e1"), truthOf("e1")]).toEqual(["0.42", false, "0.4"]);
  keepTruth("e2", "0.5", true, "0.5");
  keepTruth("e2", "", false, "0.5");
  expect([guessOf("e2"), rightOf("e2"), truthOf("e2")]).toEqual(["", null, ""]);
  clearGuesses();
  expect([rightOf("e1"), truthOf("e1")]).toEqual([null, ""]);
  vi.unstubAllGlobals();
});

it("says a number that is so with no more digits than it has", () => {
  expect([truthWords(null, 0.4), truthWords(null, 1 / 3), truthWords(null, 7)]).toEqual([
    "0.4",
    "0.3333",
    "7",
  ]);
});
