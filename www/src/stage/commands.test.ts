import { signal } from "@preact/signals";
import { expect, it, vi } from "vitest";

vi.mock("./gestures", () => ({ fitStage: () => {} }));
const { handCommand } = await import("./commands");

it("takes what a drag does in turn, to and fro and round the end", () => {
  const hand = signal("turn");
  const { run } = handCommand(hand, ["turn", "move", "scale"], { label: "", group: "" });
  const after = [0, 0, 0, 1].map((way) => {
    run?.(way);
    return hand.value;
  });
  expect(after).toEqual(["move", "scale", "turn", "scale"]);
});
