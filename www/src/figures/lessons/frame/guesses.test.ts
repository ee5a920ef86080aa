import { expect, it } from "vitest";
import { guessesIn, rightIn } from "./guesses";

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
