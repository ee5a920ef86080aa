import { expect, it } from "vitest";
import { readParameters } from "./parameters";

it("reads how a shared link begins", () => {
  const plays = ["", "?play", "?play=once", "?play=still", "?play=x"].map(
    (search) => readParameters(search).play,
  );
  expect(plays).toEqual([null, "on", "once", "still", "on"]);
});
