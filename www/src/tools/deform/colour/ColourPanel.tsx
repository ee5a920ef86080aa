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
import { MOST_ROUGHNESS } from "../changes";
import deformCss from "../deform.module.css";
import { deepest, ringed, rough } from "../facts";
import { chosen } from "../mesh/handles/chosen";
import { DetailField, LocalityField } from "../settings/ScaleFields";
import { blended, cornersOf, firstTint, isBlended, withColouring, withCorner } from "../tint";
import { roughnessWords } from "../words";

const COLOURINGS: readonly { value: Colouring; label: string; description: string }[] = [
  { value: "map", label: "Map", description: "One colour for each of the largest copies" },
  { value: "address", label: "Address", description: "A shade for each copy of a copy" },
  { value: "density", label: "Density", description: "Brighter where points fall more often" },
  { value: "grid", label: "Grid", description: "Colours of the grid, handed on to all parts like the bend" },
];

/** A curve has edges in place of pieces. */
const CURVE_COLOURINGS: typeof COLOURINGS = [
  { value: "map", label: "Copies", description: "One colour for all copies of an arc" },
  { value: "address", label: "Edges", description: "From edge to edge another colour" },
  { value: "density", label: "Plain", description: "One colour" },
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
    <section class="stack" aria-label="Colour">
      <ChoiceRow
        label="Colour by"
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
  { corner: 2, name: "Upper left" },
  { corner: 3, name: "Upper right" },
  { corner: 0, name: "Lower left" },
  { corner: 1, name: "Lower right" },
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
          <p class="hint">Choose handles on the grid to colour them one by one.</p>
        ) : (
          <ColourField
            label={some.length === 1 ? "The chosen handle" : `The ${some.length} chosen handles`}
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
            Blend the corners
          </Button>
        )}
      </div>
      <Fold title="How small parts take colour">
        <TintNumbers now={now} />
      </Fold>
    </>
  );
}

function TintNumbers({ now }: { now: Tint }) {
  return (
    <div class="stack">
      <LocalityField
        label="Locality of colours"
        value={now.kb}
        ke={now.ke}
        onChange={(kb) => changeTint((tint) => ({ ...tint, kb: Math.min(kb, tint.ke) }), "tint kb")}
      />
      <SliderField
        label="Roughness of colours"
        symbol="δ"
        value={now.delta}
        max={MOST_ROUGHNESS}
        words={roughnessWords(now.delta, rough.value)}
        onChange={(delta) => changeTint((tint) => ({ ...tint, delta }), "tint delta")}
      />
      <DetailField
        label="Detail of colours"
        value={now.ke}
        deepest={deepest.value}
        onChange={(ke) => changeTint((tint) => ({ ...tint, ke, kb: Math.min(tint.kb, ke) }), "tint ke")}
      />
      <Switch
        checked={now.superposed}
        onChange={(superposed) => changeTint((tint) => ({ ...tint, superposed }))}
      >
        All scales together
      </Switch>
    </div>
  );
}
