/** What the figures on space share: the module, links into the tool, and shapes of the gallery. */
import type { ComponentType } from "preact";
import { useEffect, useState } from "preact/hooks";
import { notify, wordsOf } from "#document/notice";
import type { MapRow3, SpaceObject, SpaceView } from "#wasm/api";
import { frond } from "#wasm/core";
import { loadSpace, solid } from "#wasm/space";
import type { Heading } from "../../kit/frame/frame";

let started = false;

/** A page that is shown as soon as space can be computed. */
export function inSpace(Page: ComponentType<Heading>): ComponentType<Heading> {
  return function InSpace(heading: Heading) {
    const [ready, setReady] = useState(started);
    useEffect(() => {
      if (started) return;
      loadSpace().then(
        () => {
          started = true;
          setReady(true);
        },
        (problem) =>
          notify({ kind: "error", text: `What computes space could not be loaded: ${wordsOf(problem)}` }),
      );
    }, []);
    return ready ? <Page {...heading} /> : null;
  };
}

/** A link that opens the tool with these objects. */
export function spaceHref(objects: SpaceObject[], view?: SpaceView): string {
  const { light } = solid.defaultSpace();
  const packed = solid.packSpace({ objects, light });
  const space = { packed, at: 0, ...(view ? { view } : {}) };
  return `#${frond.encodeScene({ ...frond.defaultScene(), tool: "space", space })}`;
}

/** The maps of a shape of the gallery. */
export function presetMaps(id: string): MapRow3[] {
  const found = solid.presets3().find((one) => one.id === id);
  if (!found) throw new Error(`The gallery of space has no shape "${id}".`);
  return found.maps;
}
