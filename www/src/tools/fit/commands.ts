/** What keys do while the fit is open. */
import { fitDocument } from "#document/fit";
import { canRedo, canUndo, redo, undo } from "#document/scene";
import { fitCommand, handCommand, switchCommand } from "#stage/commands";
import { type Command, everywhere, widgetKeys } from "#ui/commands";
import * as messages from "./messages";
import { brushSize, hand, painting } from "./stage/brush";
import { fitStage } from "./stage/camera";
import { comparing, cutting, knotsShown, outlineShown, photoShown } from "./stage/layers";
import { canRedoStroke, canUndoStroke, redoStroke, undoStroke } from "./work/mask";

const PICTURE = messages.shapeAndPicture;
const CUTTING = messages.cuttingOut;

const OUTLINE: readonly Command[] = [
  {
    id: "compare",
    label: messages.holdHideFit,
    group: PICTURE,
    keys: ["C"],
    run: () => {
      comparing.value = true;
    },
    release: () => {
      comparing.value = false;
    },
  },
  switchCommand(outlineShown, {
    id: "hide",
    label: messages.hideOrShowOutline,
    group: PICTURE,
    keys: ["H"],
  }),
  switchCommand(knotsShown, {
    id: "knots",
    label: messages.hideOrShowKnots,
    group: PICTURE,
    keys: ["N"],
  }),
  switchCommand(photoShown, {
    id: "picture",
    label: messages.hideOrShowPicture,
    group: PICTURE,
    keys: ["P"],
  }),
  fitCommand(fitStage),
  handCommand(hand, ["move", "keep", "remove"], {
    label: messages.nextOrPreviousDrag,
    group: CUTTING,
    enabled: () => cutting.peek(),
  }),
  {
    id: "size",
    label: messages.smallerOrLargerBrush,
    group: CUTTING,
    keys: [",", "."],
    enabled: () => painting.peek(),
    run(way) {
      const size = brushSize.peek() * (way === 0 ? 1 / 1.25 : 1.25);
      brushSize.value = Number(Math.min(20, Math.max(0.2, size)).toFixed(1));
    },
  },
  ...widgetKeys(CUTTING, [
    ["brush-move", messages.moveBrushWithPicture, "←", "→", "↑", "↓"],
    ["brush-paint", messages.paintThereHoldTo, "Space"],
    ["brush-drop", messages.cancelStrokeDeselectBrush, "Escape"],
  ]),
  // Strokes are no part of the document: while one paints, they are what is taken back.
  ...everywhere(
    {
      label: messages.undoLatestStrokeFirst,
      enabled: () => (cutting.value && canUndoStroke()) || canUndo.value,
      run: () => (cutting.peek() && canUndoStroke() ? undoStroke() : undo()),
    },
    {
      enabled: () => (cutting.value && canRedoStroke()) || canRedo.value,
      run: () => (cutting.peek() && canRedoStroke() ? redoStroke() : redo()),
    },
  ),
];

const GRAPH = everywhere();

export const commands = (): readonly Command[] => (fitDocument.value.mode === "outline" ? OUTLINE : GRAPH);
