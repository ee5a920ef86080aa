import { useState } from "preact/hooks";
import type { Point } from "#geometry/maps/orbit";
import { palette } from "#style/palette";
import type { MapRow } from "#wasm/api";
import { applied, choose, factsOf, follow, type Orbit } from "../orbit/follow";
import { MapButtons } from "../orbit/MapButtons";
import { OrbitControls } from "../orbit/OrbitControls";
import { Cell, OrbitPath } from "../orbit/OrbitPath";
import { Spoken } from "../orbit/Spoken";
import { TargetControls } from "../orbit/TargetControls";
import { orbitWords } from "../orbit/words";
import { State, Widget } from "./Widget";

const MAPS: readonly MapRow[] = [
  [0.5, 0, 0, 0.5, 0, 0],
  [0.5, 0, 0, 0.5, 0.5, 0],
  [0.5, 0, 0, 0.5, 0.25, 0.5],
];
const BOX = { x0: 0, y0: 0, x1: 1, y1: 1 };
const COLOURS = palette("light");
const FIRST: Orbit = [0, 2, 1].reduce(applied, { way: "apply", start: [0.4, 0.3], letters: [] } as Orbit);
const GAME = { throws: 2, reached: false, least: 2, shown: false, target: [1, 0], way: [0, 1] };
const place = ([x, y]: Point): Point => [20 + 200 * x, 220 - 200 * y];
const nothing = () => {};

/** What a point is followed by. */
export function Orbits() {
  const [orbit, setOrbit] = useState(FIRST);
  const followed = follow(MAPS, orbit);
  const game = { letters: [0, 1], maps: 3, colours: COLOURS, deepest: 5 };
  const does = { onThrow: nothing, onBack: nothing, onAgain: nothing, onNew: nothing, onShow: nothing };
  return (
    <>
      <Widget name="OrbitPath" state="three steps, towards a cell">
        <svg viewBox="0 0 240 240" width="240" height="240" aria-hidden="true">
          <Cell
            corners={[
              [0.5, 0],
              [1, 0],
              [0.75, 0.5],
            ]}
            place={place}
            reached={false}
          />
          <OrbitPath {...follow(MAPS, FIRST)} colours={COLOURS} place={place} />
        </svg>
      </Widget>
      <Widget name="OrbitControls" state="of three maps" wide>
        <OrbitControls
          orbit={orbit}
          followed={followed}
          maps={3}
          colours={COLOURS}
          words={orbitWords(orbit, followed, factsOf(MAPS, BOX, orbit), () => false)}
          onOrbit={setOrbit}
          onPoint={(point) => setOrbit(choose(orbit, MAPS, BOX, point))}
          onNearest={nothing}
        />
      </Widget>
      <Widget name="TargetControls">
        <State name="on the way" wide>
          <TargetControls {...game} {...does} game={GAME} />
        </State>
        <State name="reached" wide>
          <TargetControls {...game} {...does} game={{ ...GAME, reached: true }} />
        </State>
      </Widget>
      <Widget name="MapButtons">
        <State name="of nine maps" wide>
          <MapButtons verb="Apply map" count={9} colours={COLOURS} onMap={nothing} />
        </State>
        <State name="of 255 maps" wide>
          <MapButtons verb="Throw map" count={255} colours={COLOURS} onMap={nothing} />
        </State>
      </Widget>
      <Widget name="Spoken" state="not seen">
        <Spoken words="What is only heard." playing={false} />
      </Widget>
    </>
  );
}
