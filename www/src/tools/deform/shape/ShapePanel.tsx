import { computed } from "@preact/signals";
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
import { choose, inBox, onPath, sameBox, sameShapes } from "../changes";
import deformCss from "../deform.module.css";
import { gallery } from "../dialogs";
import { around } from "../facts";
import { PicturePanel } from "../picture/PicturePanel";
import { setSubject } from "../subject";

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
    <section class={`${deformCss["shape-panel"]} stack`} aria-label="What is bent">
      <Segmented
        label="What is bent"
        value={subject.value}
        options={[
          { value: "shape", label: "A shape" },
          { value: "picture", label: "A picture" },
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
            announce(`The grid is around the ${subject.peek()} again.`);
          }}
        >
          Fit the grid to the {subject.value}
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
        label="Taken apart into"
        name="Parts each way"
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
const knotsNote = (count: number) => (count === 0 ? "closed curve" : `closed curve, ${count} knots`);

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
        name={between ? `${name} to ${last}` : name}
        about={between ? `the morph at ${formatNumber(100 * t.value, 1)}%` : still}
        label={`${between ? `Between ${name} and ${last}` : name}. Choose another shape`}
        onChoose={() => {
          gallery.value = true;
        }}
      />
      {morphs && (
        <>
          <div class={deformCss["morph-time"]}>
            <span class="row-name">{name}</span>
            <Slider
              label={`Morph from ${name} to ${last}`}
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
              description="What is bent here is bent while the morph plays, too"
              onChange={(next) => changeDeformation((d) => ({ ...d, on: next }))}
            >
              Bend it in the morph, too
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
      title="A shape to bend"
      about="The grid is put around it. Shape A of the morph becomes it, too."
      end="bent"
      now={a.value}
      onChoose={(shape) => {
        const before = scene.peek();
        edit((now) => choose(now, shape, boxAround(shape.maps)));
        tellReplaced(before, "bent");
        announce(`${shape.name}, with the grid around it.`);
      }}
      onClose={() => {
        gallery.value = false;
      }}
    />
  );
}
