import { computed } from "@preact/signals";
import { changeDeformation, deformation, phasePlaying } from "#document/deform/bend";
import { announce } from "#document/notice";
import { reducedMotion } from "#document/preferences";
import { Button } from "#ui/controls/Button";
import { narrow } from "#ui/media";
import { pausePhase, playPhase, presentPhase } from "../clock";
import deformCss from "../deform.module.css";
import * as messages from "../messages";
import { MOTIONS, type Motion, motionOf, withMotion } from "../start/motions";
import { TimeOptions } from "../strip/TimeOptions";

// The moment is no part of it.
const keys = computed(() => deformation.value.keys);
const box = computed(() => deformation.value.box);
const now = computed(() => {
  keys.value;
  box.value;
  return motionOf(deformation.peek());
});

/** Motions to begin with, and, where the strip has no room for it, what belongs to time. */
export function MotionPanel() {
  return (
    <section class="stack" aria-label={messages.motion}>
      <div class="section-head">
        <h2>{messages.motion}</h2>
        <span class="hint">{now.value === null ? messages.ownKeys(keys.value.length) : ""}</span>
      </div>
      <div class={deformCss["motion-list"]}>
        {MOTIONS.map((motion) => (
          <Button
            key={motion.id}
            pressed={now.value === motion.id}
            description={motion.about}
            onClick={() => apply(motion)}
          >
            {motion.name}
          </Button>
        ))}
      </div>
      {narrow.value && <TimeOptions />}
    </section>
  );
}

/** The first of all motions, for whoever has none yet. */
export function sway(): void {
  const [first] = MOTIONS.filter(({ id }) => id === "sway");
  if (first) apply(first);
}

function apply({ id, name, about }: Motion): void {
  if (now.peek() === id) {
    // Space on the button that was just pressed is play and pause, as everywhere.
    if (phasePlaying.peek()) pausePhase();
    else playPhase();
    return;
  }
  phasePlaying.value = false;
  changeDeformation((d) => withMotion(d, id));
  if (id === "still") {
    announce(messages.stillOneGridFor);
    return;
  }
  const { keys, seconds, spin } = deformation.peek();
  const turns = id === "sway" && spin === "scaled" ? messages.everyPartSwaysAbout : "";
  const hint = reducedMotion.peek() ? messages.pressPlayToSee : "";
  announce(messages.motionIs(name, about, keys.length, seconds, turns, hint));
  presentPhase();
}
