import { computed, signal } from "@preact/signals";
import { standInFilm, strip, thumbnails } from "#compute/results";
import { PresetGallery } from "#curve/PresetGallery";
import { sameCurves } from "#document/curve/changes";
import { curved, curveMorph, curves } from "#document/curve/curve";
import { tellReplaced } from "#document/curve/replaced";
import { boxAround, changeDeformation, deformation } from "#document/deform/bend";
import { announce } from "#document/notice";
import { pause, setT } from "#document/playback";
import { edit, replace, scene } from "#document/scene";
import { formatNumber } from "#format/numbers";
import { CurveThumb } from "#stage/curve/CurveThumb";
import { Button } from "#ui/controls/Button";
import { Segmented } from "#ui/controls/Segmented";
import { Slider } from "#ui/controls/Slider";
import { Switch } from "#ui/controls/Switch";
import { ChoiceRow } from "#ui/panel/ChoiceRow";
import { mapsNote } from "#ui/shapes/ShapeGrid";
import { SubjectCard } from "#ui/shapes/SubjectCard";
import { Thumbnail } from "#ui/shapes/Thumbnail";
import deformCss from "../deform.module.css";
import { choose, inBox, onPath, sameBox, sameShapes } from "../deform-edits";
import { around } from "../facts";
import * as messages from "../messages";
import { PicturePanel } from "../picture/PicturePanel";
import { setSubject } from "../picture/take";

/** Whether the gallery is open. */
export const gallery = signal(false);

const subject = computed(() => deformation.value.subject);
const parts = computed(() => deformation.value.parts);
const on = computed(() => deformation.value.on);
const box = computed(() => deformation.value.box);
const bent = computed(() => scene.value.deform !== undefined);
const a = computed(() => scene.value.a);
const b = computed(() => scene.value.b);
const t = computed(() => scene.value.t);

/** What is bent: a shape, the morph as it stands, or a picture. */
export function ShapePanel() {
  return (
    <section class={`${deformCss["shape-panel"]} stack`} aria-label={messages.subject}>
      <Segmented
        label={messages.subject}
        value={subject.value}
        options={[
          { value: "shape", label: messages.shape },
          { value: "picture", label: messages.picture },
        ]}
        onChange={setSubject}
      />
      {subject.value === "picture" ? <Picture /> : <Shape />}
      {bent.value && !sameBox(box.value, around.value) && (
        <Button
          kind="quiet"
          icon="whole"
          onClick={() => {
            changeDeformation((d) => inBox(d, around.peek()));
            announce(messages.gridAround(subject.peek()));
          }}
        >
          {messages.fitGrid(subject.value)}
        </Button>
      )}
    </section>
  );
}

function Picture() {
  return (
    <>
      <PicturePanel />
      <ChoiceRow
        label={messages.splitInto}
        name={messages.partsEachWay}
        value={parts.value === 2 ? "2" : "3"}
        options={[
          { value: "2", label: "2 × 2" },
          { value: "3", label: "3 × 3" },
        ]}
        onChange={(next) => changeDeformation((d) => ({ ...d, parts: next === "2" ? 2 : 3 }))}
      />
    </>
  );
}

/** Of a curve whose knots are not read yet nothing is counted. */
const knotsNote = (count: number) => (count === 0 ? messages.closedCurve : messages.curveOf(count));

function Shape() {
  const ends = curves.value;
  const { name: first, maps: all, preset } = a.value;
  const morphs = ends ? !sameCurves(ends) : !sameShapes(a.value, b.value);
  const [name, last] = ends ? [ends.a.name, ends.b.name] : [first, b.value.name];
  const between = t.value > 0 && morphs;
  const still = ends
    ? knotsNote(ends.a.curve.knots.length)
    : `${mapsNote({ maps: all })}${preset === undefined ? ", edited" : ""}`;
  return (
    <>
      <SubjectCard
        picture={
          ends && !between ? (
            <CurveThumb morph={curveMorph.value} s={0} />
          ) : (
            <Thumbnail
              bitmap={
                between ? frameAt(t.value) : (thumbnails.value.get("a") ?? thumbnails.value.get(preset ?? ""))
              }
            />
          )
        }
        name={between ? messages.fromTo(name, last) : name}
        about={between ? messages.morphAt(formatNumber(100 * t.value, 1)) : still}
        label={messages.chooseAnother(between ? messages.betweenShapes(name, last) : name)}
        onChoose={() => {
          gallery.value = true;
        }}
      />
      {morphs && (
        <>
          <div class={deformCss["morph-time"]}>
            <span class="row-name">{name}</span>
            <Slider
              label={messages.morphFrom(name, last)}
              value={t.value}
              valueText={`${formatNumber(100 * t.value, 1)}%`}
              onChange={(next) => {
                pause();
                replace(onPath(scene.peek()));
                setT(next);
              }}
            />
            <span class="row-name">{last}</span>
          </div>
          {bent.value && (
            <Switch
              checked={on.value}
              description={messages.morphThenShowsThis}
              onChange={(next) => changeDeformation((d) => ({ ...d, on: next }))}
            >
              {messages.deformInMorphToo}
            </Switch>
          )}
        </>
      )}
    </>
  );
}

function frameAt(at: number): ImageBitmap | null {
  const frames = curved.value ? standInFilm.value : strip.value;
  const away = frames.map((frame) => Math.abs(frame.t - at));
  return frames[away.indexOf(Math.min(...away))]?.bitmap ?? null;
}

/** Every preset, and the closed curves, to be bent. */
export function Gallery() {
  if (!gallery.value) return null;
  return (
    <PresetGallery
      title={messages.chooseShapeToDeform}
      about={messages.gridPlacedAroundAlso}
      end="bent"
      now={a.value}
      onChoose={(shape) => {
        const before = scene.peek();
        edit((now) => choose(now, shape, boxAround(shape.maps)));
        tellReplaced(before, "bent");
        announce(messages.withGrid(shape.name));
      }}
      onClose={() => {
        gallery.value = false;
      }}
    />
  );
}
