import { beforeEach, expect, test, vi } from "vitest";
import type { OpenedPicture } from "#workers/fit/trace-types";
import { changeMask, settings, watchMask } from "./mask";
import { takeSource } from "./source";

// No worker answers: what is asked of it is no matter here.
vi.mock("#workers/fit/client", () => ({ fitTask: () => new Promise(() => {}) }));

const take = (id: number) =>
  takeSource({
    kind: "picture",
    name: `leaf ${id}`,
    picture: { kind: "picture", id, bitmap: { close() {} } } as unknown as OpenedPicture,
  });

beforeEach(() => void vi.useFakeTimers());

test("what was said of a picture is there when the tool is opened again", () => {
  take(1);
  const leave = watchMask();
  changeMask((now) => ({ ...now, stalk: "remove", threshold: 0.25 }));
  leave();
  const leaveAgain = watchMask();
  expect(settings.peek()).toMatchObject({ stalk: "remove", threshold: 0.25 });
  // Of another picture nothing was said; what was said of the first is kept with it.
  take(2);
  expect(settings.peek().stalk).toBe("keep");
  leaveAgain();
  take(1);
  const end = watchMask();
  expect(settings.peek()).toMatchObject({ stalk: "remove", threshold: 0.25 });
  end();
});
