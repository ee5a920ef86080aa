import { endGesture } from "#document/scene";
import type { Screen } from "#geometry/coordinates";
import { mesh } from "../document";
import meshCss from "../mesh.module.css";
import { choose, chosen, lead, lookAt } from "./chosen";
import { handleId, handleKey } from "./keyboard";
import { handleWords } from "./words";

export interface HandleProps {
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
export function Handle({ index, at, chosen: isChosen, leading, under, hint }: HandleProps) {
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
