import { useEffect } from "preact/hooks";
import { comparing } from "../stage/layers";

const hold = (on: boolean) => {
  comparing.value = on;
};

/** While it is held, the outline is seen without the fit. */
export function CompareButton() {
  useEffect(() => () => hold(false), []);
  return (
    <button
      type="button"
      class="button compare-button"
      aria-pressed={comparing.value}
      title="Hold to see the outline, or the picture, without the fit (C)"
      onPointerDown={(event) => {
        if (event.button !== 0) return;
        event.currentTarget.setPointerCapture(event.pointerId);
        hold(true);
      }}
      onPointerUp={() => hold(false)}
      onPointerCancel={() => hold(false)}
      onLostPointerCapture={() => hold(false)}
      onContextMenu={(event) => event.preventDefault()}
      onKeyDown={(event) => {
        if (event.key !== " " && event.key !== "Enter") return;
        event.preventDefault();
        hold(true);
      }}
      onKeyUp={(event) => {
        if (event.key === " " || event.key === "Enter") hold(false);
      }}
      onBlur={() => hold(false)}
    >
      Hold to compare
    </button>
  );
}
