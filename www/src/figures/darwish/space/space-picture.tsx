import { useEffect, useMemo, useRef, useState } from "preact/hooks";
import { wordsOf } from "#document/notice";
import { dark } from "#document/preferences";
import { palette } from "#style/palette";
import type { SpaceLight, SpaceView } from "#wasm/api";
import { solid } from "#wasm/space";
import { type PictureRequest, pictureOf, type Shown } from "#workers/space/complete-picture";
import { usePixels } from "../../kit/picture/canvas";
import pictureCss from "../../kit/picture/picture.module.css";
import { useValue } from "../../kit/workers";
import { Carving } from "./carving";
import { orbitLabel, useOrbit } from "./orbit";
import css from "./space.module.css";

interface SpacePictureProps {
  /** The parameters now. */
  objects: readonly Shown[];
  view: SpaceView;
  /** Taken when somebody turns the view; without it the view stands. */
  onView?: (view: SpaceView) => void;
  light?: SpaceLight;
  /** What is seen, in words. */
  label: string;
}

/** Objects of space, carved by a worker, as large as their place: coarse while they move, complete at rest. */
export function SpacePicture({ objects, view, onView, light, label }: SpacePictureProps) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const pixels = usePixels(canvas);
  const onDark = useValue(dark);
  const [problem, setProblem] = useState<string | null>(null);
  const [complete, setComplete] = useState(false);
  const [works] = useState(() => new Carving((request, signal) => pictureOf(request, { signal, lane: 1 })));

  const wish = useMemo((): PictureRequest | null => {
    if (!pixels) return null;
    const theme = onDark ? "dark" : "light";
    return {
      objects: [...objects],
      view,
      light: light ?? solid.defaultSpace().light,
      ...pixels,
      factor: 1,
      palette: palette(theme),
      ground: getComputedStyle(document.documentElement).getPropertyValue("--stage").trim(),
    };
  }, [objects, view, light, pixels, onDark]);

  useEffect(() => {
    setComplete(false);
    if (!wish) return;
    works.take(wish, {
      paint(image, whole) {
        if (canvas.current) paint(canvas.current, image);
        setProblem(null);
        if (whole) setComplete(true);
      },
      fail: (thrown) => setProblem(wordsOf(thrown)),
    });
  }, [wish, works]);
  useEffect(() => () => works.end(), [works]);

  const orbit = useOrbit(view, onView);
  return (
    <div class={css["space-picture-box"]}>
      <canvas
        ref={canvas}
        class={`${pictureCss["figure-picture"]} ${css["space-picture"]} ${onView ? css["turned"] : ""}`}
        data-complete={complete ? "" : undefined}
        {...orbitLabel(label, onView !== undefined)}
        {...orbit}
      />
      {problem !== null && (
        <p class={css["space-problem"]} role="status">
          {problem}
        </p>
      )}
    </div>
  );
}

function paint(canvas: HTMLCanvasElement, image: ImageData): void {
  canvas.width = image.width;
  canvas.height = image.height;
  canvas.getContext("2d")?.putImageData(image, 0, 0);
}
