import { expect, it } from "vitest";
import { askedBy, optionsIn } from "./protocol";

it("is asked by what it knows, in whole, and says what it does not know", () => {
  expect(askedBy({ frond: 1, type: "play" })).toEqual({ type: "play" });
  expect(askedBy({ frond: 1, type: "seek", t: 0.25, more: 1 })).toEqual({ type: "seek", t: 0.25 });
  expect(askedBy({ frond: 1, type: "open", fragment: "https://x.example/#a=fern" })).toEqual({
    type: "open",
    fragment: "a=fern",
  });
  for (const wrong of [
    { frond: 1 },
    { frond: 1, type: "evaluate", code: "1" },
    { frond: 1, type: "seek", t: "0.5" },
    { frond: 1, type: "seek", t: Number.NaN },
    { frond: 1, type: "seek", t: 2 },
    { frond: 1, type: "open" },
    { frond: 1, type: "open", fragment: "a".repeat(2 ** 21) },
    { frond: 2, type: "play" },
  ]) {
    expect(typeof askedBy(wrong)).toBe("string");
  }
});

it("leaves alone what is not for it", () => {
  for (const other of [null, undefined, 7, "play", { type: "play" }, [], new Map()])
    expect(askedBy(other)).toBeNull();
});

it("shows nothing but the picture and a slider unless asked", () => {
  expect(optionsIn("")).toEqual({
    locus: false,
    verdict: false,
    panel: false,
    controls: true,
    theme: null,
    origin: null,
  });
  expect(optionsIn("?verdict&locus&panel&controls=none&theme=dark&origin=https://a.example/page")).toEqual({
    locus: true,
    verdict: true,
    panel: true,
    controls: false,
    theme: "dark",
    origin: "https://a.example",
  });
  // An origin that is none lets nobody in, rather than everybody.
  expect(optionsIn("?origin=nonsense").origin).toBe("null:");
});
