import type { MapRow3, SpaceView } from "#wasm/api";
import { SpaceDots } from "../../darwish/space/space-dots";

/** Twenty thirds of a cube, those on top leaning to the side: of points, so that nothing is fetched. */
const MAPS: MapRow3[] = [0, 1, 2].flatMap((z) =>
  [0, 1, 2].flatMap((y) =>
    [0, 1, 2]
      .filter((x) => [x, y, z].filter((k) => k === 1).length < 2)
      .map(
        (x): MapRow3 => [
          1 / 3,
          0,
          0.06 * z,
          0,
          1 / 3,
          0,
          0,
          0,
          1 / 3,
          (x - 1) / 1.5 + 0.18 * z,
          (y - 1) / 1.5,
          (z - 1) / 1.5,
        ],
      ),
  ),
);
const VIEW: SpaceView = { target: [0.25, 0, 0], distance: 6, turn: 0.5, tilt: 0.42, angle: 0.62 };

export const Thumb = () => <SpaceDots maps={MAPS} view={VIEW} />;
