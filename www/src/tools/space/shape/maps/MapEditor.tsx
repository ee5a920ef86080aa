import { useState } from "preact/hooks";
import { announce, wordsOf } from "#document/notice";
import { endGesture } from "#document/scene";
import { changeMaps, hasKeyedMaps, reshapeSpace, tellOfMorph } from "#document/space/edits";
import { chosen, editSpace, space, spaceFrame, timeline } from "#document/space/space";
import { formatNumber } from "#format/numbers";
import { about3, determinant3, scale3 } from "#geometry/maps/affine3";
import { Button } from "#ui/controls/Button";
import { Problem } from "#ui/panel/Problem";
import { MapList, MapTools } from "#ui/shapes/MapList";
import type { MapRow3, Point3 } from "#wasm/api";
import { solid } from "#wasm/space";
import * as messages from "../messages";
import { factsOf, object } from "../now";
import { Swatch } from "../object/ObjectPanel";
import { presets } from "../object/presets";
import { MOST_MAPS, withShape } from "../object-edits";
import shapeCss from "../shape.module.css";
import { TwelveFields } from "./TwelveFields";

/** Takes maps that are a shape; of others it says what is wrong, and the last good ones stay. */
function offer(maps: MapRow3[], gesture?: string): string | undefined {
  const before = object.peek();
  if (!before) return undefined;
  try {
    solid.validate3(maps);
    const index = chosen.peek();
    const options = gesture === undefined ? {} : { gesture };
    // Maps come and go for all time; their numbers may be those of a moment.
    if (timeline.peek() && maps.length === before.maps.length) changeMaps(maps, options);
    else {
      const morphed = space.peek()?.morph !== undefined;
      editSpace((now) => withShape(now, index, { name: before.name, maps }), options);
      tellOfMorph(morphed);
    }
    return undefined;
  } catch (problem) {
    return wordsOf(problem);
  }
}

/** A half about the middle of the shape: what a new map begins as. */
function half(maps: MapRow3[]): MapRow3 {
  const centre: Point3 = factsOf(maps)?.centre ?? [0, 0, 0];
  return about3(scale3([0.5, 0.5, 0.5]), centre);
}

/** The maps that the chosen object is made with, number by number. */
export function MapEditor() {
  const [open, setOpen] = useState<number | null>(0);
  const [problem, setProblem] = useState<string | null>(null);
  const { maps: made = [], name = "", preset } = object.value ?? {};
  const keyed = hasKeyedMaps(timeline.value, chosen.value) && !(chosen.value === 0 && space.value?.morph);
  const maps = (keyed && spaceFrame.value?.objects[chosen.value]?.maps) || made;
  const origin = presets().find((one) => one.name === name);
  /** For a button, whose refusal is told under the list. */
  const press = (next: MapRow3[], then: number, said: string) => {
    const refusal = offer(next);
    if (refusal !== undefined) return setProblem(messages.mapsUnchanged(refusal));
    setProblem(null);
    setOpen(then);
    announce(said);
  };
  const fields = (index: number) => {
    const map = maps[index];
    return (
      map && (
        <>
          <TwelveFields
            map={map}
            onChange={(next, place) => offer(maps.with(index, next), `map ${index} ${place}`)}
            onDone={endGesture}
          />
          <MapTools maps={maps} index={index} most={MOST_MAPS} onPress={press} />
        </>
      )
    );
  };
  return (
    <div class="stack">
      <p class="hint">{timeline.value ? messages.originalMapsKeyed : messages.originalMaps}</p>
      <MapList
        maps={maps.map(mapWords)}
        open={open}
        onOpen={setOpen}
        swatch={(index) => <Swatch map={index} />}
        fields={fields}
      />
      <Problem words={problem} />
      <div class={shapeCss["solid-buttons"]}>
        <Button
          icon="add"
          disabled={maps.length >= MOST_MAPS}
          onClick={() => press([...maps, half(maps)], maps.length, messages.mapNew(maps.length + 1))}
        >
          {messages.addMap}
        </Button>
        {origin && preset === undefined && (
          <Button
            kind="quiet"
            icon="reset"
            onClick={() => {
              const { id, maps: first } = origin;
              const back = { preset: id, name, maps: first };
              if (!reshapeSpace((now) => withShape(now, chosen.peek(), back))) return;
              setProblem(null);
              announce(messages.backToDone(name));
            }}
          >
            {messages.backTo(name)}
          </Button>
        )}
      </div>
      {maps.length >= MOST_MAPS && <p class="hint">{messages.mostMaps(MOST_MAPS)}</p>}
    </div>
  );
}

/** A map at a glance: how large what it makes is, and whether it is mirrored or flat. */
function mapWords(map: MapRow3): string {
  const volume = determinant3(map);
  if (Math.abs(volume) < 1e-12) return "flat";
  return `× ${formatNumber(Math.cbrt(Math.abs(volume)), 3)}${volume < 0 ? ", mirrored" : ""}`;
}
