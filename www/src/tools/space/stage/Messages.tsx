import { computed, signal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { lookingAround, motionProblem, space, spaceFrame, spaceView } from "#document/space/space";
import { Button } from "#ui/controls/Button";
import { solid } from "#wasm/space";
import * as messages from "../messages";
import { backToFlight, showWhole } from "./actions";
import { type Ball, eyeOf, sightOf } from "./camera";
import { sight } from "./sight";
import css from "./stage.module.css";
import { insideWords, TROUBLE_WORDS, troubleOf } from "./stage-text";
import { painted } from "./state";

const trouble = computed(() => {
  const now = sight.value;
  const view = spaceView.value;
  return troubleOf(now && view ? sightOf(view, now.ball) : null, painted.value);
});

/** Names of the objects around the eye, found when everything rests. */
const around = signal<readonly string[]>([]);
const complete = computed(() => painted.value.complete);
const flown = computed(() => lookingAround.value && spaceFrame.value?.view !== undefined);

/** What the stage has to say, over the picture. */
export function Messages() {
  useEffect(
    () =>
      complete.subscribe((now) => {
        around.value = now ? objectsAround() : [];
      }),
    [],
  );
  const what = trouble.value;
  const { problem } = painted.value;
  const inside = what === null ? insideWords(around.value) : null;
  return (
    <>
      <div class={css["space-messages"]} role="status">
        {motionProblem.value !== null && <p class={css["space-message"]}>{motionProblem.value}</p>}
        {problem !== null && (
          <div class={css["space-message"]}>
            <p>{problem}</p>
            <Button onClick={showWhole}>{messages.showAll}</Button>
          </div>
        )}
        {problem === null && what !== null && (
          <div class={css["space-message"]}>
            <p>{TROUBLE_WORDS[what]}</p>
            <Button onClick={showWhole}>{messages.showAll}</Button>
          </div>
        )}
        {inside !== null && <p class={css["space-inside"]}>{inside}</p>}
      </div>
      {flown.value && (
        <Button
          class={css["space-flight"]}
          description={messages.youLookingAroundReturn}
          onClick={backToFlight}
        >
          {messages.backToFlight}
        </Button>
      )}
    </>
  );
}

/** Balls that the eye is well within: near their rims it is in front of things more often than not. */
const WITHIN = 0.8;
const balls = new Map<string, Ball>();

function objectsAround(): string[] {
  const view = spaceView.peek();
  const now = sight.peek();
  if (!view || !now || sightOf(view, now.ball) !== "around") return [];
  const eye = eyeOf(view);
  const names = space.peek()?.objects ?? [];
  return now.objects.flatMap(({ maps }, i) => {
    const key = JSON.stringify(maps);
    let ball = balls.get(key);
    if (!ball) {
      if (balls.size > 200) balls.clear();
      const handle = new solid.SpacePicture([{ maps }]);
      const [x = 0, y = 0, z = 0] = handle.centre;
      ball = { centre: [x, y, z], radius: handle.radius };
      balls.set(key, ball);
      handle.free();
    }
    const { centre, radius } = ball;
    const far = Math.hypot(eye[0] - centre[0], eye[1] - centre[1], eye[2] - centre[2]);
    return far < WITHIN * radius ? [names[i]?.name ?? messages.objectNumber(i + 1)] : [];
  });
}
