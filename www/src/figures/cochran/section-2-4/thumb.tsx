import { loadCurves } from "#wasm/curve";
import { Small } from "../../kit/picture/small";
import { Profile } from "../graphs/profile";
import { FACTORS, PLACES } from "./page";
import { curveThrough, drawn } from "./plane-curve";

/** What must be there before it is shown. */
export const needs = [loadCurves];

export function Thumb() {
  const curve = curveThrough(PLACES, FACTORS, [false, false]);
  const lines =
    typeof curve === "string"
      ? []
      : drawn(curve).pieces.map((points, i) => ({ points, colour: i, width: 1.25 }));
  return (
    <Small shape={1.5}>
      <Profile
        label={null}
        bare
        x={{ min: -0.4, max: 1.4, ticks: [] }}
        y={{ min: -0.3, max: 0.9, ticks: [] }}
        lines={lines}
      />
    </Small>
  );
}
