import { computed } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { phasePlaying } from "#document/deform/bend";
import { type Screen, screen } from "#geometry/coordinates";
import { stageSize } from "#stage/view";
import { useOwnId } from "#ui/id";
import { unbent } from "../facts";
import * as messages from "../messages";
import { mesh } from "./document";
import { chosen, lead } from "./handles/chosen";
import { HandBar } from "./handles/HandBar";
import { Handle } from "./handles/Handle";
import { HINT } from "./handles/keyboard";
import { handlesOf } from "./hit";
import { Lines } from "./Lines";
import css from "./mesh.module.css";
import { attachPointer, under } from "./pointer";
import { gridShown } from "./shown";

/** So many that their circles would hide the picture. */
const dense = computed(() => mesh.value.columns * mesh.value.rows > 64);

/** The mesh on the stage: its grid, its handles, and what the hand does with them. */
export function DeformOverlay() {
  const root = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const element = root.current;
    const pane = element?.closest<HTMLElement>(".pane");
    return element && pane ? attachPointer(pane, element) : undefined;
  }, []);
  return (
    <div
      ref={root}
      class={`${css["mesh"]} ${phasePlaying.value ? css["playing"] : ""} ${dense.value ? css["dense"] : ""}`}
    >
      {gridShown.value && !unbent.value && (
        <>
          <Lines />
          <Handles />
          <HandBar />
        </>
      )}
    </div>
  );
}

const places = computed(() => handlesOf(mesh.value));

function Handles() {
  const hint = useOwnId("mesh-hint");
  const { columns, rows } = mesh.value;
  return (
    // biome-ignore lint/a11y/useSemanticElements: a fieldset is for forms
    <div role="group" aria-label={messages.gridOf(columns, rows)}>
      <p id={hint} class="unseen">
        {HINT}
      </p>
      {places.value.map((at, index) => {
        const leading = index === lead.value;
        if (!leading && !isSeen(at)) return null;
        return (
          <Handle
            key={index}
            index={index}
            at={leading ? kept(at) : at}
            chosen={chosen.value.has(index)}
            leading={leading}
            under={under.value === index}
            hint={hint}
          />
        );
      })}
    </div>
  );
}

function isSeen({ x, y }: Screen): boolean {
  const { width, height } = stageSize.value;
  return x > -22 && y > -22 && x < width + 22 && y < height + 22;
}

/** The one that keys act on is at the edge when it is out of sight. */
function kept({ x, y }: Screen): Screen {
  const { width, height } = stageSize.value;
  return screen(Math.min(width, Math.max(0, x)), Math.min(height, Math.max(0, y)));
}
