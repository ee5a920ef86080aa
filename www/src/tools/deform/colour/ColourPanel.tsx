import { computed } from "@preact/signals";
import { changeDeformation, deformation } from "#document/deform/bend";
import { edit, scene } from "#document/scene";
import { Palettes } from "#stage/later";
import { GREY } from "#style/colours";
import { Button } from "#ui/controls/Button";
import { SliderField } from "#ui/controls/SliderField";
import { Switch } from "#ui/controls/Switch";
import { ChoiceRow } from "#ui/panel/ChoiceRow";
import { ColourField } from "#ui/panel/ColourField";
import { Fold } from "#ui/panel/Fold";
import type { Colouring, Tint } from "#wasm/api";
import deformCss from "../deform.module.css";
import { MOST_ROUGHNESS } from "../deform-edits";
import { roughnessWords } from "../deform-text";
import { deepest, ringed, rough } from "../facts";
import { chosen } from "../mesh/mesh-state";
import * as messages from "../messages";
import { DetailField, LocalityField } from "../settings/fields";
import { blended, cornersOf, firstTint, isBlended, withColouring, withCorner } from "../tint";

const COLOURINGS: readonly { value: Colouring; label: string; description: string }[] = [
  { value: "map", label: messages.map, description: messages.oneColourForEach },
  { value: "address", label: messages.address, description: messages.shadeForEachCopy },
  { value: "density", label: messages.density, description: messages.brighterWhereMorePoints },
  { value: "grid", label: messages.grid, description: messages.coloursGridPassedOn },
];

/** A curve has edges in place of pieces. */
const CURVE_COLOURINGS: typeof COLOURINGS = [
  { value: "map", label: messages.copies, description: messages.oneColourForAll },
  { value: "address", label: messages.edges, description: messages.coloursAlternateFromEdge },
  { value: "density", label: messages.plain, description: messages.oneColour },
];

const colouring = computed(() => scene.value.colouring);
const tint = computed(() => deformation.value.tint ?? null);
const subject = computed(() => deformation.value.subject);
const columns = computed(() => deformation.value.columns);
const rows = computed(() => deformation.value.rows);

/** How the shape is coloured; a picture has its own colours. */
export function ColourPanel() {
  if (subject.value === "picture") return null;
  return (
    <section class="stack" aria-label={messages.colour}>
      <ChoiceRow
        label={messages.colourBy}
        value={ringed.value && colouring.value === "grid" ? "density" : colouring.value}
        options={ringed.value ? CURVE_COLOURINGS : COLOURINGS}
        onChange={(next) => edit((before) => withColouring(before, next, deformation.peek()))}
      />
      <Palettes />
      {colouring.value === "grid" && !ringed.value && (
        <GridColours now={tint.value ?? firstTint(deformation.value)} />
      )}
    </section>
  );
}

function changeTint(change: (tint: Tint) => Tint, gesture?: string): void {
  changeDeformation(
    (d) => ({ ...d, tint: change(d.tint ?? firstTint(d)) }),
    gesture === undefined ? {} : { gesture },
  );
}

/** Upper ones first, as they are seen. */
const CORNERS = [
  { corner: 2, name: messages.upperLeft },
  { corner: 3, name: messages.upperRight },
  { corner: 0, name: messages.lowerLeft },
  { corner: 1, name: messages.lowerRight },
] as const;

function GridColours({ now }: { now: Tint }) {
  const sides = { columns: columns.value, rows: rows.value };
  const four = cornersOf(now.colours, sides);
  const some = [...chosen.value];
  const first = some[0];
  return (
    <>
      <div class={deformCss["tint-corners"]}>
        {CORNERS.map(({ corner, name }) => (
          <ColourField
            key={corner}
            label={name}
            value={four[corner]}
            onChange={(next) =>
              changeTint(
                (tint) => ({ ...tint, colours: withCorner(tint.colours, sides, corner, next) }),
                name,
              )
            }
          />
        ))}
      </div>
      <div class="row">
        {first === undefined ? (
          <p class="hint">{messages.selectHandlesOnGrid}</p>
        ) : (
          <ColourField
            label={some.length === 1 ? messages.selectedHandle : messages.selectedHandles(some.length)}
            value={now.colours[first] ?? GREY}
            onChange={(next) =>
              changeTint(
                (tint) => ({ ...tint, colours: tint.colours.map((c, i) => (some.includes(i) ? next : c)) }),
                "tint chosen",
              )
            }
          />
        )}
        {!isBlended(now.colours, sides) && (
          <Button
            kind="quiet"
            icon="reset"
            onClick={() => changeTint((tint) => ({ ...tint, colours: blended(four, sides) }))}
          >
            {messages.blendCorners}
          </Button>
        )}
      </div>
      <Fold title={messages.howSmallPartsColoured}>
        <TintNumbers now={now} />
      </Fold>
    </>
  );
}

function TintNumbers({ now }: { now: Tint }) {
  return (
    <div class="stack">
      <LocalityField
        label={messages.localityColours}
        value={now.kb}
        ke={now.ke}
        onChange={(kb) => changeTint((tint) => ({ ...tint, kb: Math.min(kb, tint.ke) }), messages.tintKb)}
      />
      <SliderField
        label={messages.roughnessColours}
        symbol="δ"
        value={now.delta}
        max={MOST_ROUGHNESS}
        words={roughnessWords(now.delta, rough.value)}
        onChange={(delta) => changeTint((tint) => ({ ...tint, delta }), messages.tintDelta)}
      />
      <DetailField
        label={messages.detailColours}
        value={now.ke}
        deepest={deepest.value}
        onChange={(ke) => changeTint((tint) => ({ ...tint, ke, kb: Math.min(tint.kb, ke) }), "tint ke")}
      />
      <Switch
        checked={now.superposed}
        onChange={(superposed) => changeTint((tint) => ({ ...tint, superposed }))}
      >
        {messages.allScalesTogether}
      </Switch>
    </div>
  );
}
