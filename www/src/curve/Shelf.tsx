import { useMemo } from "preact/hooks";
import { curveBoxAt, curved, curves } from "#document/curve/curve";
import { bendCurve, chooseCurve, curvePresets, fitted, shapeOf } from "#document/curve/edits";
import { tellReplaced } from "#document/curve/replaced";
import { announce } from "#document/notice";
import { scene } from "#document/scene";
import { curveThumb } from "#stage/curve/thumb";
import { stageStyle } from "#stage/picture-style";
import { useOwnId } from "#ui/id";
import { ShapeGrid, type ShapeItem } from "#ui/shapes/ShapeGrid";
import type { Curve, CurveShape } from "#wasm/api";
import { rough } from "#wasm/curve";
import css from "./curve.module.css";
import * as messages from "./messages";

interface Item extends ShapeItem {
  shape: CurveShape;
}

/** Curves to choose: those of the gallery, what was fitted last, and such of the document as are in neither. */
function items(): Item[] {
  const all: Item[] = curvePresets().map((preset) => ({ ...preset, shape: shapeOf(preset) }));
  const add = (id: string, shape: CurveShape | null | undefined, about: string) => {
    if (!shape || all.some((item) => item.shape.curve === shape.curve || item.id === shape.preset)) return;
    all.push({ id, name: shape.name, about, shape });
  };
  add("fit", fitted(), messages.yourLatestFit);
  add("a", curves.peek()?.a, messages.shapeAsNow);
  add("b", curves.peek()?.b, messages.shapeBAsNow);
  return all;
}

const SIZE = { width: 160, height: 120 };

/** What was drawn last, by id: of what, and in which colours. */
const drawn = new Map<string, { curve: Curve; palette: readonly string[]; bitmap: ImageBitmap }>();

/** The pictures, by id: a few, and soon made, so that none is ever missing. */
function picturesOf(all: readonly Item[], palette: readonly string[]): Map<string, ImageBitmap> {
  const pictures = new Map<string, ImageBitmap>();
  for (const { id, shape } of all) {
    let made = drawn.get(id);
    if (made?.curve !== shape.curve || made.palette !== palette) {
      try {
        const morph = new rough.CurveMorph(shape.curve, null);
        const bitmap = curveThumb(morph, 0, curveBoxAt(morph, 0), SIZE, palette);
        morph.free();
        made = { curve: shape.curve, palette, bitmap };
        drawn.set(id, made);
      } catch {
        // Without a picture it can still be chosen.
        continue;
      }
    }
    pictures.set(id, made.bitmap);
  }
  return pictures;
}

/** What a gallery shows of curves, wherever it is. */
interface ShelfProps {
  /** The end that is chosen for, or the shape that is bent. */
  end: "a" | "b" | "bent";
  onChosen: () => void;
}

/** The closed curves of a gallery. */
export function Shelf({ end, onChosen }: ShelfProps) {
  const title = useOwnId("shelf");
  const { palette } = stageStyle.value;
  const all = useMemo(items, []);
  const pictures = useMemo(() => picturesOf(all, palette), [all, palette]);
  const now = curves.value?.[end === "b" ? "b" : "a"];
  const choose = ({ name, shape }: Item) => {
    const before = scene.peek();
    if (end === "bent") bendCurve(shape);
    else chooseCurve(end, shape);
    tellReplaced(before, end);
    announce(end === "bent" ? messages.withGrid(name) : messages.shapeNow(end.toUpperCase(), name));
    onChosen();
  };
  return (
    <section class={css["shelf"]} aria-labelledby={title}>
      <h3 id={title}>{messages.closedCurves}</h3>
      <p class="hint">
        {messages.outlinesMadeSmallerCopies}
        {!curved.peek() && end !== "bent" && <> {messages.outlinesMorphOnlyInto}</>}
      </p>
      <ShapeGrid
        presets={all}
        pictures={pictures}
        noteOf={({ shape }) => messages.knots(shape.curve.knots.length)}
        chosen={all.find(({ shape, id }) => now && (id === now.preset || shape.curve === now.curve))?.id}
        onChoose={choose}
      />
    </section>
  );
}
