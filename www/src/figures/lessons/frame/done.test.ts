import { afterEach, expect, it } from "vitest";
import { clearDone, done, markDone, marksIn } from "./done";

afterEach(clearDone);

it("marks and unmarks, once each", () => {
  markDone("e1");
  const first = done.value;
  markDone("e1");
  expect(done.value).toBe(first);
  markDone("e1.2");
  expect([...done.value]).toEqual(["e1", "e1.2"]);
  markDone("e1", false);
  expect([...done.value]).toEqual(["e1.2"]);
});

it("reads nothing but names of lessons and exercises", () => {
  expect(marksIn(null).size).toBe(0);
  expect([...marksIn("e1 <b> e2.3 e1 ../x e99999 e3.123")]).toEqual(["e1", "e2.3"]);
  expect(marksIn(Array.from({ length: 5000 }, (_, i) => `e${i}`).join(" ")).size).toBe(1000);
});
