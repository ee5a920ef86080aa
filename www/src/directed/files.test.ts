import { expect, it } from "vitest";
import { oneState, withDirected } from "#document/directed/changes";
import { scene } from "#document/scene";
import { jsonOf } from "./files";

it("holds the whole document, as it is read again, and the system of the moment", () => {
  const shape = { ...oneState(scene.peek().b), name: "Mine" };
  const document = withDirected(scene.peek(), "a", shape);
  const { about, now, ...read } = JSON.parse(jsonOf(document, { states: shape.states }));
  expect(read).toEqual(document);
  expect(now).toEqual(shape.states);
  expect(about).toContain("`directed`");
  expect(JSON.parse(jsonOf(document, null))).not.toHaveProperty("now");
});
