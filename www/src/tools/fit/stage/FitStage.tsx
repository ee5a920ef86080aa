import { effect, signal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { dark, theme } from "#document/preferences";
import { watchSize } from "#stage/picture";
import { GREY } from "#style/colours";
import { palette } from "#style/palette";
import { IconButton } from "#ui/controls/Button";
import fitCss from "../fit.module.css";
import { statusWords } from "../fit-text";
import * as messages from "../messages";
import { brushKey, brushKeyUp, endStroke, painting } from "./brush";
import { effectiveView, fitStage, stageSize, view, watchCamera, zoom } from "./camera";
import { type Colours, dropVeil, paint } from "./draw";
import { attachGestures, stageKey } from "./gestures";
import { sight } from "./sight";

const LABEL = messages.outlineAndFitArrow;

/** The outline, the fit over it, and below them the picture. */
export function FitStage() {
  const host = useRef<HTMLDivElement>(null);
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => {
    const element = host.current;
    const target = canvas.current;
    const context = target?.getContext("2d");
    if (!element || !target || !context) return;
    const device = signal({ width: 0, height: 0, ratio: 1 });
    const stopSize = watchSize(element, (css, now) => {
      target.width = now.width;
      target.height = now.height;
      device.value = now;
      stageSize.value = css;
    });
    const stopCamera = watchCamera();
    let frame = 0;
    const stopDraw = effect(() => {
      const size = device.value;
      const now = { view: effectiveView.value, sight: sight.value, dark: dark.value };
      // The style sheet follows the choice of a theme: by the next frame it has.
      theme.value;
      cancelAnimationFrame(frame);
      frame = requestAnimationFrame(() => paint(context, size, now.view, now.sight, coloursOf(now.dark)));
    });
    const stopGestures = attachGestures(element);
    return () => {
      stopGestures();
      stopDraw();
      cancelAnimationFrame(frame);
      stopCamera();
      stopSize();
      dropVeil();
    };
  }, []);
  return (
    <>
      <div
        ref={host}
        class={`picture ${fitCss["fit-picture"]} ${painting.value ? fitCss["painting"] : ""}`}
        role="application"
        aria-label={LABEL}
        // biome-ignore lint/a11y/noNoninteractiveTabindex: it takes keys
        tabIndex={0}
        data-testid="fit-stage"
        onKeyDown={(event) => {
          if (event.target !== event.currentTarget) return;
          if ((painting.peek() && brushKey(event)) || stageKey(event)) {
            event.preventDefault();
            event.stopPropagation();
          }
        }}
        onKeyUp={brushKeyUp}
        onBlur={endStroke}
      >
        <canvas ref={canvas} />
      </div>
      <div class="stage-foot">
        <Status />
        <Readout />
      </div>
    </>
  );
}

/** What has been reached, while it improves and after. */
function Status() {
  return (
    <p class={`${fitCss["fit-status"]} number`} data-testid="fit-status">
      {statusWords.value}
    </p>
  );
}

function Readout() {
  const z = zoom.value;
  return (
    <div class="readout number">
      <span>{z < 10 ? `×${z.toFixed(1)}` : z < 1e4 ? `×${Math.round(z)}` : `×${z.toExponential(1)}`}</span>
      <IconButton
        icon="whole"
        kind="quiet"
        label={messages.fitToStage}
        command="fit"
        disabled={view.value === null}
        onClick={fitStage}
      />
    </div>
  );
}

/** The theme's own, read where the style sheet has them. */
function coloursOf(isDark: boolean): Colours {
  const style = getComputedStyle(document.documentElement);
  const of = (name: string) => style.getPropertyValue(`--${name}`).trim();
  return {
    stage: of("stage"),
    ink: of("ink"),
    quiet: of("ink-2"),
    fit: palette(isDark ? "dark" : "light")[2] ?? GREY,
    bad: of("bad"),
    accent: of("accent"),
    arcs: palette(isDark ? "dark" : "light"),
  };
}
