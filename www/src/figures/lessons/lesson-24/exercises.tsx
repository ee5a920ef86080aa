import { fixed } from "#format/numbers";
import type { MapRow3 } from "#wasm/api";
import { useKept } from "../../kit/state/kept";
import { Exercise } from "../frame/exercise";
import { Shadow } from "./shadow";
import { EYE, type Eye, NEAR_DEGREES, offDiagonal, offEdges, SPONGE, STANDING } from "./shapes";

export function Exercises() {
  return (
    <>
      <Turned
        number={1}
        maps={SPONGE}
        name="the sponge"
        first={{ turn: 0, tilt: 0 }}
        off={offDiagonal}
        ask="Turn the sponge until the light goes along a diagonal of its cube, from corner to opposite corner. What has become of all the holes?"
        hints={[
          "The corner that is nearest to you has to hide the one that is farthest away.",
          "Go round by 45°, so that an edge is in front. Then go up until the top corner in front comes to the middle: a little more than a third of the way to straight above.",
        ]}
        found="Its shadow there is the whole hexagon, the same as that of the cube: the light finds no way through."
      />
      <Turned
        number={2}
        maps={STANDING}
        name="the tetrahedron, standing on a face"
        first={{ turn: 10, tilt: 0 }}
        off={offEdges}
        ask="The tetrahedron again, now standing on a face. Find a way of lighting it that makes its shadow a square without a hole."
        hints={[
          "Look for two edges that do not meet. The light has to come at a right angle to both.",
          "Go round until a corner of the foot is in front: the slanting edge from there to the top then stands upright in the middle. Go up until the edge behind it crosses it in the middle.",
        ]}
        found="The two edges cross at a right angle: they are the diagonals of the square."
      />
    </>
  );
}

interface TurnedProps {
  number: number;
  maps: MapRow3[];
  name: string;
  first: Eye;
  /** How many degrees off it is. */
  off: (eye: Eye) => number;
  ask: string;
  hints: readonly string[];
  /** What there is to be seen once it is solved. */
  found: string;
}

function Turned({ number, maps, name, first, off, ask, hints, found }: TurnedProps) {
  const [eye, setEye] = useKept(`x${number}.eye`, first, EYE);
  const degrees = off(eye);
  const solved = degrees <= NEAR_DEGREES;
  return (
    <Exercise
      number={number}
      ask={ask}
      hints={hints}
      solved={solved}
      status={`The lamp is ${fixed(degrees, 1)}° off. ${solved ? found : ""}`}
    >
      <Shadow maps={maps} name={name} eye={eye} onEye={setEye} />
    </Exercise>
  );
}
