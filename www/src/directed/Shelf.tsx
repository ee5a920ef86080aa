import { useEffect, useRef, useState } from "preact/hooks";
import { curvePresets, fitted } from "#document/curve/edits";
import { tellReplaced } from "#document/curve/replaced";
import { chooseDirected } from "#document/directed/edits";
import { chooseOutline } from "#document/directed/outlines";
import { selection } from "#document/morph";
import { announce, wordsOf } from "#document/notice";
import { scene } from "#document/scene";
import { directedPicture, type PictureSize } from "#stage/directed/thumb";
import { stageStyle } from "#stage/picture-style";
import { useOwnId } from "#ui/id";
import { ShapeGrid } from "#ui/shapes/ShapeGrid";
import { loadCurves } from "#wasm/curve";
import { loadDirected } from "#wasm/directed";
import { type DirectedChoice, directedChoices } from "./choices";
import css from "./directed.module.css";
import * as messages from "./messages";
import { stateWords } from "./words";

const SIZE: PictureSize = { width: 160, height: 120 };

const MORPHS = {
  outline: messages.theyMorphIntoShapes,
  other: messages.otherShapeStaysAnd,
};

interface ShelfProps {
  end: "a" | "b";
  onChosen: () => void;
}

/** The graph-directed shapes of a gallery, each as soon as its picture is there. */
export function DirectedShelf({ end, onChosen }: ShelfProps) {
  const title = useOwnId("shelf");
  const [presets, setPresets] = useState<readonly DirectedChoice[]>([]);
  const [problem, setProblem] = useState<string | null>(null);
  const [pictures, setPictures] = useState<ReadonlyMap<string, ImageBitmap | null>>(new Map());
  const { colouring, palette } = stageStyle.value;
  const section = useRef<HTMLElement>(null);
  useEffect(() => {
    // Most who open a gallery want what stands above: what shows these is fetched for who looks here.
    const seen = new IntersectionObserver((entries) => {
      if (!entries.some(({ isIntersecting }) => isIntersecting)) return;
      seen.disconnect();
      Promise.all([loadDirected(), loadCurves()]).then(
        () => setPresets(directedChoices(curvePresets(), fitted())),
        (reason) => setProblem(wordsOf(reason)),
      );
    });
    if (section.current) seen.observe(section.current);
    return () => seen.disconnect();
  }, []);
  useEffect(() => {
    const ended = new AbortController();
    const put = (id: string, bitmap: ImageBitmap | null) => {
      if (!ended.signal.aborted) setPictures((before) => new Map(before).set(id, bitmap));
    };
    for (const { id, system } of presets) {
      directedPicture(system, SIZE, { colouring, palette }, ended.signal).then(
        (bitmap) => put(id, bitmap),
        // Without a picture it can still be chosen.
        () => put(id, null),
      );
    }
    return () => ended.abort();
  }, [presets, colouring, palette]);
  const choose = ({ id, name, system, outline }: DirectedChoice) => {
    // Nothing of a system is edited any more.
    selection.value = null;
    const before = scene.peek();
    const chosen = () => {
      tellReplaced(before, end);
      announce(messages.shapeNow(end.toUpperCase(), name));
    };
    if (outline) void chooseOutline(end, outline).then((done) => done && chosen());
    else {
      chooseDirected(end, { preset: id, name, ...system });
      chosen();
    }
    onChosen();
  };
  const drawn = new Map([...pictures].flatMap(([id, bitmap]) => (bitmap ? [[id, bitmap] as const] : [])));
  return (
    <section
      ref={section}
      class={css["directed-shelf"]}
      aria-labelledby={title}
      // While nothing in it can be walked to, it can itself, and so comes into sight.
      tabIndex={pictures.size > 0 ? -1 : 0}
    >
      <h3 id={title}>{messages.shapesSeveralStates}</h3>
      <p class="hint">
        {problem === null
          ? messages.aboutShelf(MORPHS[scene.value.curves ? "outline" : "other"])
          : messages.notLoaded(problem)}
      </p>
      <ShapeGrid
        presets={presets.filter(({ id }) => pictures.has(id))}
        pictures={drawn}
        noteOf={({ system }) => stateWords(system)}
        chosen={scene.value.directed?.[end].preset}
        onChoose={choose}
      />
    </section>
  );
}
