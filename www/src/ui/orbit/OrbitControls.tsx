import { useEffect, useRef, useState } from "preact/hooks";
import { reducedMotion } from "#document/preferences";
import { type Point, thrown } from "#geometry/maps/orbit";
import { Button } from "../controls/Button";
import { NumberField } from "../controls/NumberField";
import * as messages from "../messages";
import {
  applied,
  back,
  type Followed,
  type follow,
  isFull,
  MOST_STEPS,
  type Orbit,
  readOn,
  startAgain,
  stepsOf,
} from "./follow";
import { MapButtons } from "./MapButtons";
import css from "./orbit.module.css";
import { Spoken } from "./Spoken";
import { addressText, orbitSpoken } from "./words";

interface OrbitControlsProps {
  orbit: Orbit;
  followed: Followed;
  /** How many maps there are. */
  maps: number;
  weights?: readonly number[] | undefined;
  colours: readonly string[];
  /** Where the point is and how it came there. */
  words: string;
  onOrbit: (next: Orbit) => void;
  /** Another point, by numbers. */
  onPoint: (point: Point) => void;
  /** The nearest point of the shape is taken, where the point is off it. */
  onNearest: () => void;
}

const STEP_MS = 700;
const MANY = 100;

/** How a point is chosen and followed, and its address. */
export function OrbitControls(props: OrbitControlsProps) {
  const { orbit, followed, maps, weights, colours, words, onOrbit, onPoint, onNearest } = props;
  const [playing, setPlaying] = useState(false);
  const still = reducedMotion.value;
  const full = isFull(orbit);
  const throwOne = (now: Orbit) => applied(now, thrown(maps, Math.random(), weights));
  const step = (now: Orbit) => (now.way === "read" ? readOn(now) : throwOne(now));
  const latest = useRef(() => {});
  latest.current = () => {
    if (full) setPlaying(false);
    else onOrbit(step(orbit));
  };
  const plays = playing && !still && !full;
  useEffect(() => {
    if (!plays) return;
    const timer = setInterval(() => latest.current(), STEP_MS);
    return () => clearInterval(timer);
  }, [plays]);
  useEffect(() => {
    if (full) setPlaying(false);
  }, [full]);
  const many = () => {
    let next = orbit;
    for (let i = 0; i < MANY; i++) next = throwOne(next);
    onOrbit(next);
  };
  const [x, y] = chosen(orbit, followed);
  const reading = orbit.way !== "apply";
  return (
    <div class={css["orbit-controls"]}>
      {!reading && (
        <MapButtons
          verb={messages.applyMap}
          count={maps}
          colours={colours}
          disabled={full}
          onMap={(letter) => onOrbit(applied(orbit, letter))}
        />
      )}
      <p class={css["orbit-address"]}>
        <span>{messages.address}</span>
        <strong data-testid="orbit-address">
          {followed.address.length === 0
            ? messages.notKnownYet
            : addressText(followed.address, !full || !reading)}
        </strong>
      </p>
      <div class={css["orbit-row"]}>
        {reading ? (
          <Button disabled={full} onClick={() => onOrbit(readOn(orbit))}>
            {messages.nextLetter}
          </Button>
        ) : (
          <>
            <Button
              disabled={full}
              description={weights ? messages.randomMapByWeights : messages.randomMapEachEqually}
              onClick={() => onOrbit(throwOne(orbit))}
            >
              {messages.throwLabel}
            </Button>
            <Button disabled={full} description={messages.atMostSteps(MOST_STEPS)} onClick={many}>
              {messages.throws(MANY)}
            </Button>
          </>
        )}
        {!still && (
          <Button icon={plays ? "pause" : "play"} disabled={full} onClick={() => setPlaying(!plays)}>
            {plays ? messages.pause : messages.play}
          </Button>
        )}
        <Button icon="back" disabled={stepsOf(orbit) === 0} onClick={() => onOrbit(back(orbit))}>
          {messages.back}
        </Button>
        <Button icon="reset" disabled={stepsOf(orbit) === 0} onClick={() => onOrbit(startAgain(orbit))}>
          {messages.startOver}
        </Button>
      </div>
      <p class={css["orbit-words"]} data-testid="orbit-words">
        {words}
      </p>
      {orbit.way === "off" && orbit.nearest && (
        <div class={css["orbit-row"]}>
          <Button onClick={onNearest}>{messages.useNearestPointShape}</Button>
        </div>
      )}
      <div class={css["orbit-fields"]}>
        <NumberField
          label={messages.selectedPoint}
          symbol="x"
          value={x}
          onChange={(next) => onPoint([next, y])}
        />
        <NumberField
          label={messages.selectedPoint}
          symbol="y"
          value={y}
          onChange={(next) => onPoint([x, next])}
        />
      </div>
      <Spoken words={orbitSpoken(orbit, followed, words)} playing={plays} />
    </div>
  );
}

/** The point that was chosen, where it is now. */
function chosen(orbit: Orbit, { points }: ReturnType<typeof follow>): Point {
  if (orbit.way === "apply") return orbit.start;
  return points[0] ?? [0, 0];
}
