import { computed, signal } from "@preact/signals";
import { ownColours, pieceColours, withoutColours } from "#document/colours";
import { dark } from "#document/preferences";
import { edit, scene } from "#document/scene";
import { GREY } from "#style/colours";
import { palette } from "#style/palette";
import { SAFE } from "#style/safe-palettes";
import { useOwnId } from "#ui/id";
import { ColourField } from "#ui/panel/ColourField";
import { Fold } from "#ui/panel/Fold";
import * as messages from "../messages";
import css from "./palettes.module.css";

const own = computed(() => ownColours(scene.value));
const count = computed(() => Math.max(scene.value.a.maps.length, scene.value.b.maps.length));

const same = (p: readonly string[], q: readonly string[]) =>
  p.length === q.length && p.every((colour, i) => colour === q[i]?.toLowerCase());

/** They are chosen one by one, even where they are still those of a published palette. */
const oneByOne = signal(false);

/** Which one it is: the page's, one of those that are published, or another. */
const chosen = computed(() => {
  const now = own.value;
  if (now === null) return "page";
  return oneByOne.value ? "own" : (SAFE.find(({ colours }) => same(colours, now))?.id ?? "own");
});

function take(colours: readonly string[], own = false): void {
  oneByOne.value = own;
  edit((before) => ({ ...before, palette: [...colours] }));
}

/** The colours of the maps: the page's, one of three that colour-blind eyes tell apart, or one's own. */
export function Palettes() {
  if (scene.value.curves) return null;
  const name =
    { page: messages.fronds, own: messages.custom }[chosen.value] ??
    SAFE.find(({ id }) => id === chosen.value)?.name;
  return (
    <Fold title={messages.coloursMaps} now={name}>
      <Choices />
    </Fold>
  );
}

function Choices() {
  const group = useOwnId("palette");
  const theme = dark.value ? "dark" : "light";
  const row = (id: string, name: string, about: string, colours: readonly string[], onChoose: () => void) => (
    <label key={id} class={css["choice"]}>
      <input type="radio" name={group} checked={chosen.value === id} onChange={onChoose} />
      <span>{name}</span>
      <span class={css["patches"]} aria-hidden="true">
        {colours.map((colour, i) => (
          <span key={i} style={{ background: colour }} />
        ))}
      </span>
      <span class={css["about"]}>{about}</span>
    </label>
  );
  return (
    <div class="stack">
      <div class={css["choices"]} role="radiogroup" aria-label={messages.coloursMaps}>
        {row("page", messages.fronds, messages.afterOkabeAndIto, palette(theme), () => edit(withoutColours))}
        {SAFE.map(({ id, name, source, colours }) => row(id, name, source, colours, () => take(colours)))}
        {row("own", messages.custom2, messages.colourForEachMap, own.value ?? [], () => take(each(), true))}
      </div>
      {chosen.value === "own" && (
        <div class={css["own"]}>
          {each().map((colour, index) => (
            // Maps have no name but their number: it is their key.
            <ColourField
              key={index}
              label={messages.mapNumber(index + 1)}
              value={colour}
              onChange={(next) =>
                edit((before) => ({ ...before, palette: each().with(index, next) }), { gesture: "palette" })
              }
            />
          ))}
        </div>
      )}
      <p class="hint">{messages.publishedPalettesColourBlind}</p>
    </div>
  );
}

/** A colour for each map, as they are now. */
function each(): string[] {
  const now = pieceColours(dark.peek() ? "dark" : "light");
  return Array.from({ length: count.peek() }, (_, i) => now[i % now.length] ?? GREY);
}
