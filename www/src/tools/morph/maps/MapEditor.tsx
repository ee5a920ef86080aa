import { useEffect, useRef, useState } from "preact/hooks";
import { OwnShapes } from "#curve/OwnShapes";
import { learnFormulas } from "#document/editing/exact";
import { editFrame } from "#document/editing/frame";
import { ranks, selection } from "#document/morph";
import { announce, notify, wordsOf } from "#document/notice";
import { copyName, keepShape, LONGEST_NAME, ownShapes } from "#document/own-shapes";
import { originOf } from "#document/presets";
import { edit, endGesture, scene } from "#document/scene";
import { UNIT } from "#geometry/boxes";
import { mapWords, reflect } from "#geometry/maps/affine2";
import { beside, oneMore } from "#geometry/maps/beside";
import { exactOf } from "#geometry/maps/exact";
import { snapping } from "#stage/handles/held";
import { Button, IconButton } from "#ui/controls/Button";
import { Segmented } from "#ui/controls/Segmented";
import { Switch } from "#ui/controls/Switch";
import { Fold } from "#ui/panel/Fold";
import { Problem } from "#ui/panel/Problem";
import { MapList, MapTools } from "#ui/shapes/MapList";
import { NameInput } from "#ui/shapes/NameInput";
import type { MapRow, Shape } from "#wasm/api";
import { frond } from "#wasm/core";
import { askForNew, endEditing } from "../dialogs";
import { shapes } from "../document-signals";
import { choose, type End, MOST_MAPS, nameOf } from "../edits";
import { Swatch } from "../shapes/Swatch";
import { FrameFold } from "./FrameFold";
import { NumberFields, PartFields } from "./MapFields";
import { removeChosen, rename, setMaps } from "./map-edits";
import css from "./maps.module.css";
import * as messages from "./messages";
import { Weights } from "./Weights";
import { WholeShape } from "./WholeShape";

/** Why maps cannot be a shape, in a sentence; nothing where they can. */
function problemWith(maps: MapRow[]): string | undefined {
  try {
    frond.validate({ maps });
    return undefined;
  } catch (problem) {
    return wordsOf(problem);
  }
}

/** The middle of a shape, for what is mirrored or added. */
function middle(maps: MapRow[]): [number, number] {
  try {
    const { min, max } = frond.bounds({ maps });
    return [(min[0] + max[0]) / 2, (min[1] + max[1]) / 2];
  } catch {
    return [0, 0];
  }
}

interface MapEditorProps {
  target: End;
  chosen: number | null;
  /** It is taken in hand as a whole. */
  whole: boolean;
}

/** One end by numbers, map by map or as a whole; on the stage the same are parallelograms to drag. */
export function MapEditor({ target, chosen, whole }: MapEditorProps) {
  const heading = useRef<HTMLHeadingElement>(null);
  const exact = exactOf(shapes[target].value);
  const written = exact.join();
  // biome-ignore lint/correctness/useExhaustiveDependencies: the same formulas are read once
  useEffect(() => {
    void learnFormulas(exact).catch(() => {});
  }, [written]);
  // The button that was pressed is further down now.
  useEffect(() => {
    const side = heading.current?.closest(".side");
    if (document.activeElement === document.body || side?.contains(document.activeElement))
      heading.current?.focus({ preventScroll: true });
    if (side) side.scrollTop = 0;
    // What comes after the maps begins at its top, too.
    return () => {
      if (side) side.scrollTop = 0;
    };
  }, []);
  return (
    <section class={css["editor"]} aria-label={messages.mapsOfShape(nameOf(target))}>
      <header class="section-head">
        <h2 tabIndex={-1} ref={heading}>
          {messages.mapsOf(nameOf(target))}
        </h2>
        <Button kind="primary" icon="check" onClick={endEditing}>
          {messages.done}
        </Button>
      </header>
      <NameInput
        label={messages.nameOfShape(nameOf(target))}
        name={shapes[target].value.name}
        longest={LONGEST_NAME}
        onName={(name) => {
          edit((before) => rename(before, target, name));
          announce(messages.shapeRenamed(nameOf(target), name));
        }}
      />
      <Segmented
        label={messages.edit}
        value={whole ? "whole" : "maps"}
        options={[
          { value: "maps", label: messages.mapByMap },
          { value: "whole", label: messages.wholeShape },
        ]}
        command="whole"
        onChange={(next) => {
          endGesture();
          selection.value = { target, map: chosen, ...(next === "whole" ? { whole: true } : {}) };
        }}
      />
      {whole ? <WholeShape target={target} /> : <Maps target={target} chosen={chosen} />}
    </section>
  );
}

/** The maps one by one. */
function Maps({ target, chosen }: { target: End; chosen: number | null }) {
  const [form, setForm] = useState<"parts" | "numbers">("parts");
  const [problem, setProblem] = useState<{ words: string; from: "map" | "list" } | null>(null);
  const shape = shapes[target].value;
  const { maps } = shape;
  const exact = exactOf(shape);
  const origin = originOf(shape);
  const pick = (map: number | null) => {
    setProblem(null);
    selection.value = { target, map };
  };

  /** Takes a set that is a shape; of any other it says what is wrong, and the last good one stays. */
  const offer = (next: MapRow[], gesture?: string, exact?: readonly string[]): string | undefined => {
    const refusal = problemWith(next);
    if (refusal !== undefined) return refusal;
    setProblem(null);
    edit((before) => setMaps(before, target, next, exact), gesture === undefined ? {} : { gesture });
    return undefined;
  };
  /** The same for a button, whose refusal is told beside it. */
  const press = (next: MapRow[], then: number | null, said: string, from: "map" | "list" = "map") => {
    const refusal = offer(next);
    if (refusal !== undefined) return setProblem({ words: messages.mapsUnchanged(refusal), from });
    pick(then);
    announce(said);
  };
  const change = (index: number, map: MapRow, gesture?: string, exact?: readonly string[]) => {
    const { maps: now } = scene.peek()[target];
    // A formula that was waited for is of a map that has changed since.
    if (now[index] !== maps[index]) return undefined;
    return offer(now.with(index, map), gesture, exact);
  };

  /** Where maps are put. */
  const frame = () => editFrame.peek()?.box ?? UNIT;
  const mirror = (index: number, map: MapRow) =>
    press(maps.with(index, reflect(map, middle(maps)[0])), index, messages.mapMirrored(index + 1));

  const fields = (index: number) => {
    const map = maps[index];
    const Fields = form === "parts" ? PartFields : NumberFields;
    return (
      map && (
        <>
          <Fields
            map={map}
            among={maps}
            exact={exact}
            onChange={(next, more, field) => change(index, next, `map-${target}-${index}-${field}`, more)}
            onDone={endGesture}
          />
          <MapTools
            maps={maps}
            index={index}
            most={MOST_MAPS}
            copyOf={(one) => beside(maps, one, frame())}
            onPress={press}
          >
            <IconButton
              icon="reflect"
              label={messages.mirrorThisMap}
              kind="quiet"
              onClick={() => mirror(index, map)}
            />
          </MapTools>
          {problem?.from === "map" && <Problem words={problem.words} />}
        </>
      )
    );
  };

  return (
    <>
      <p class="hint">{messages.dragOutlinesOnPicture}</p>
      <Segmented
        label={messages.mapFormat}
        value={form}
        onChange={setForm}
        options={[
          { value: "parts", label: messages.turnStretchMove },
          { value: "numbers", label: messages.sixNumbers },
        ]}
      />
      <Switch
        checked={snapping.value}
        onChange={(on) => {
          snapping.value = on;
        }}
      >
        {messages.snapToCornersEdges}
      </Switch>
      {maps.length === 1 && <p class="hint">{messages.shapeSingleMapPoint}</p>}
      <MapList
        numbered
        maps={maps.map(mapWords)}
        open={chosen}
        onOpen={pick}
        onRemove={(index) => {
          pick(index);
          removeChosen();
        }}
        swatch={(index) => <Swatch map={index} colour={ranks[target].value[index]} />}
        fields={fields}
      />
      <Problem words={problem?.from === "list" ? problem.words : null} />
      <div class={css["editor-foot"]}>
        <Button
          icon="add"
          disabled={maps.length >= MOST_MAPS}
          onClick={() =>
            press([...maps, oneMore(maps, frame())], maps.length, messages.mapNew(maps.length + 1), "list")
          }
        >
          {messages.addMap}
        </Button>
        <Button
          kind="quiet"
          icon="reset"
          disabled={origin === undefined || (shape.preset !== undefined && !shape.weights)}
          description={origin === undefined ? messages.thisShapeNotFrom : messages.backToOrigin(origin.name)}
          onClick={() => {
            if (origin === undefined) return;
            setProblem(null);
            edit((before) => ({
              ...before,
              [target]: { preset: origin.id, name: origin.name, maps: origin.maps },
            }));
            pick(0);
            announce(messages.backToOriginDone(origin.name));
          }}
        >
          {messages.reset}
        </Button>
      </div>
      <div>
        <FrameFold target={target} />
        <Weights target={target} />
        <AtHand target={target} />
      </div>
    </>
  );
}

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
