import { computed } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { phasePlaying } from "#document/deform/bend";
import { endGesture } from "#document/scene";
import { type Screen, screen } from "#geometry/coordinates";
import { stageSize } from "#stage/view";
import { IconButton } from "#ui/controls/Button";
import { Segmented } from "#ui/controls/Segmented";
import { useOwnId } from "#ui/id";
import { handleWords } from "../deform-text";
import { unbent } from "../facts";
import * as messages from "../messages";
import { resetChosen } from "./edit";
import { handlesOf } from "./hit";
import { HINT, handleId, handleKey } from "./keyboard";
import { Lines } from "./Lines";
import css from "./mesh.module.css";
import meshCss from "./mesh.module.css";
import { choose, chosen, gridShown, type Hand, hand, lead, lookAt, mesh } from "./mesh-state";
import { attachPointer, under } from "./pointer";

const HANDS: readonly { value: Hand; label: string; description: string }[] = [
  { value: "move", label: messages.move, description: messages.dragBesideHandlesTo },
  { value: "pull", label: messages.pull, description: messages.dragAnywhereToPull },
  {
    value: "choose",
    label: messages.select,
    description: messages.dragFrameToSelect,
  },
];

/** What the hand does on the picture: fingers have no modifier keys. */
function HandBar() {
  return (
    <div class={meshCss["mesh-bar"]}>
      {chosen.value.size > 0 && (
        <IconButton
          icon="reset"
          label={chosen.value.size === 1 ? messages.resetHandle : messages.resetSelectedHandles}
          onClick={resetChosen}
        />
      )}
      <Segmented
        label={messages.dragMode}
        options={HANDS}
        value={hand.value}
        onChange={(next) => {
          hand.value = next;
        }}
      />
    </div>
  );
}

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

interface HandleProps {
  index: number;
  at: Screen;
  chosen: boolean;
  /** Whether Tab comes here. */
  leading: boolean;
  under: boolean;
  /** Of the paragraph that tells the keys. */
  hint: string;
}

/** One control point. Pointers meet it through the mesh, which knows the nearest; it has the keys and the words. */
function Handle({ index, at, chosen: isChosen, leading, under, hint }: HandleProps) {
  return (
    <button
      id={handleId(index)}
      type="button"
      class={`${meshCss["mesh-handle"]} ${under ? meshCss["under"] : ""}`}
      style={{ translate: `${at.x.toFixed(1)}px ${at.y.toFixed(1)}px` }}
      tabIndex={leading ? 0 : -1}
      aria-label={handleWords(mesh.value, index)}
      aria-pressed={isChosen}
      aria-describedby={hint}
      onFocus={() => {
        if (lead.peek() !== index || chosen.peek().size === 0) lookAt(index);
      }}
      // Without a pointer: a reader, or a voice.
      onClick={(event) => {
        if (event.detail === 0) choose([index], index);
      }}
      onKeyDown={(event) => {
        if (!handleKey(index, event)) return;
        event.preventDefault();
        event.stopPropagation();
      }}
      onKeyUp={(event) => {
        // Space has done its work when it went down.
        if (event.key === " ") event.preventDefault();
        endGesture();
      }}
      onBlur={endGesture}
    />
  );
}
