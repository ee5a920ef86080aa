import { OwnShapes } from "#curve/OwnShapes";
import { selection } from "#document/morph";
import { announce, notify } from "#document/notice";
import { copyName, keepShape, ownShapes } from "#document/own-shapes";
import { edit } from "#document/scene";
import { Button } from "#ui/controls/Button";
import { Fold } from "#ui/panel/Fold";
import type { Shape } from "#wasm/api";
import { choose, type End } from "../changes";
import { askForNew } from "../dialogs";
import { shapes } from "../parts";
import { rename } from "./changes";
import css from "./maps.module.css";
import * as messages from "./messages";

/** The shapes that a person keeps, at hand while one is edited: to go on with another, or with a copy. */
export function AtHand({ target }: { target: End }) {
  const kept = ownShapes.value.length;
  return (
    <Fold title={messages.yourShapes} now={kept === 0 ? messages.noneYet : `${kept}`}>
      <div class="stack">
        <p class="hint">{messages.saveShapeAndWork}</p>
        <div class={css["editor-foot"]}>
          <Button icon="check" onClick={() => keep(shapes[target].peek())}>
            {messages.save}
          </Button>
          <Button icon="copy" description={messages.saveAndContinueWith} onClick={() => duplicate(target)}>
            {messages.duplicate}
          </Button>
          <Button icon="add" onClick={() => askForNew(target)}>
            {messages.newLabel}
          </Button>
        </div>
        <OwnShapes small onChoose={(shape) => take(target, shape)} />
      </div>
    </Fold>
  );
}

function keep(shape: Shape): boolean {
  const problem = keepShape(shape);
  if (problem !== null) notify({ kind: "info", text: problem });
  else announce(messages.isKept(shape.name));
  return problem === null;
}

function duplicate(target: End): void {
  const shape = shapes[target].peek();
  if (!keep(shape)) return;
  const name = copyName(shape.name, new Set(ownShapes.peek().map((one) => one.name)));
  edit((before) => rename(before, target, name));
  announce(messages.keptAndEdited(shape.name, name));
}

function take(target: End, shape: Shape): void {
  edit((before) => choose(before, target, shape));
  selection.value = { target, map: 0 };
  announce(messages.nowEdited(shape.name));
}
