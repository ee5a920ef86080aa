import { expect, it } from "vitest";
import { guessesIn } from "./guesses";

it("reads nothing but guesses of lessons", () => {
  expect([...guessesIn('{"e1":"0.45","e99999":"x","<b>":"y","e2":3}')]).toEqual([["e1", "0.45"]]);
  for (const text of [null, "", "[1", "null", "7", '"e1"']) expect(guessesIn(text).size).toBe(0);
  expect(guessesIn(JSON.stringify({ e1: "x".repeat(900) })).get("e1")?.length).toBe(160);
});
