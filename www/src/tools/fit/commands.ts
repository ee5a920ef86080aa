/** What keys do while the fit is open. */
import { fitDocument } from "#document/fit";
import { canRedo, canUndo, redo, undo } from "#document/scene";
import { fitCommand, handCommand, switchCommand } from "#stage/commands";
import { type Command, everywhere, widgetKeys } from "#ui/commands";
import { brushSize, hand, painting } from "./stage/brush";
import { fitStage } from "./stage/camera";
import { comparing, cutting, knotsShown, outlineShown, photoShown } from "./stage/layers";
import { canRedoStroke, canUndoStroke, redoStroke, undoStroke } from "./work/mask";

const PICTURE = "Shape and picture";
const CUTTING = "Cutting out";

const OUTLINE: readonly Command[] = [
  {
    id: "compare",
    label: "Hold: the outline without the fit",
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
    label: "Hide the outline, show it",
    group: PICTURE,
    keys: ["H"],
  }),
  switchCommand(knotsShown, {
    id: "knots",
    label: "Show the knots, hide them",
    group: PICTURE,
    keys: ["N"],
  }),
  switchCommand(photoShown, {
    id: "picture",
    label: "Hide the picture, show it",
    group: PICTURE,
    keys: ["P"],
  }),
  fitCommand(fitStage),
  handCommand(hand, ["move", "keep", "remove"], {
    label: "What a drag does, the next, the one before: move, leaf, not leaf",
    group: CUTTING,
    enabled: () => cutting.peek(),
  }),
  {
    id: "size",
    label: "A smaller brush, a larger one",
    group: CUTTING,
    keys: [",", "."],
    enabled: () => painting.peek(),
    run(way) {
      const size = brushSize.peek() * (way === 0 ? 1 / 1.25 : 1.25);
      brushSize.value = Number(Math.min(20, Math.max(0.2, size)).toFixed(1));
    },
  },
  ...widgetKeys(CUTTING, [
    ["brush-move", "Move the brush, where the picture has the focus; Shift finer", "←", "→", "↑", "↓"],
    ["brush-paint", "Paint there; held, while it moves", "Space"],
    ["brush-drop", "Drop the stroke, put the brush away", "Escape"],
  ]),
  // Strokes are no part of the document: while one paints, they are what is taken back.
  ...everywhere(
    {
      label: "Undo: the last stroke first",
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
