import { useEffect } from "preact/hooks";
import { editFrame, frameAround, setFrame } from "#document/editing/frame";
import { scene } from "#document/scene";
import { type Box, UNIT } from "#geometry/boxes";
import { frameShown } from "#stage/handles/frame-grips";
import { Button } from "#ui/controls/Button";
import { NumberField } from "#ui/controls/NumberField";
import { Segmented } from "#ui/controls/Segmented";
import { Fold } from "#ui/panel/Fold";
import type { End } from "../edits";
import css from "./maps.module.css";
import * as messages from "./messages";

const same = (p: Box, q: Box) => p.x0 === q.x0 && p.y0 === q.y0 && p.x1 === q.x1 && p.y1 === q.y1;

/** The frame whose images the maps are shown as: it stays, or follows the shape. */
export function FrameFold({ target }: { target: End }) {
  const frame = editFrame.value;
  if (!frame) return null;
  const { box, follows } = frame;
  const words = follows ? messages.followsShape : same(box, UNIT) ? messages.unitSquare : messages.fixedNow;
  return (
    <Fold title={messages.frameOutlines} now={words}>
      <FrameFields target={target} box={box} follows={follows} />
    </Fold>
  );
}

/** Far from where numbers of a picture end. */
const FARTHEST = 1e6;
const SMALLEST = 1e-6;

function FrameFields({ target, box, follows }: { target: End; box: Box; follows: boolean }) {
  useEffect(() => {
    frameShown.value = true;
    return () => {
      frameShown.value = false;
    };
  }, []);
  const maps = () => scene.peek()[target].maps;
  const put = (next: Box) => setFrame(maps(), next);
  const width = box.x1 - box.x0;
  const height = box.y1 - box.y0;
  return (
    <div class="stack">
      <p class="hint">{follows ? messages.outlineIs : messages.outlineIsDrag}</p>
      <Segmented
        label={messages.frame}
        value={follows ? "follows" : "stays"}
        onChange={(next) => setFrame(maps(), box, { follows: next === "follows" })}
        options={[
          { value: "stays", label: messages.fixed },
          { value: "follows", label: messages.followsShape2 },
        ]}
      />
      {!follows && (
        <>
          <div class={css["map-fields"]}>
            <NumberField
              label={messages.left}
              value={box.x0}
              min={-FARTHEST}
              max={FARTHEST}
              onChange={(x0) => put({ ...box, x0, x1: x0 + width })}
            />
            <NumberField
              label={messages.bottom}
              value={box.y0}
              min={-FARTHEST}
              max={FARTHEST}
              onChange={(y0) => put({ ...box, y0, y1: y0 + height })}
            />
            <NumberField
              label={messages.width}
              value={width}
              min={SMALLEST}
              max={FARTHEST}
              onChange={(next) => put({ ...box, x1: box.x0 + next })}
            />
            <NumberField
              label={messages.height}
              value={height}
              min={SMALLEST}
              max={FARTHEST}
              onChange={(next) => put({ ...box, y1: box.y0 + next })}
            />
          </div>
          <div class={css["editor-foot"]}>
            <Button disabled={same(box, UNIT)} onClick={() => put(UNIT)}>
              {messages.unitSquare2}
            </Button>
            <Button onClick={() => put(frameAround(maps()))}>{messages.aroundShape}</Button>
          </div>
        </>
      )}
    </div>
  );
}
