import { useEffect } from "preact/hooks";
import { chosen, spaceReady } from "#document/space/space";
import { formatNumber } from "#format/numbers";
import { Fold } from "#ui/panel/Fold";
import { mapsNote } from "#ui/shapes/ShapeGrid";
import { FactsPanel } from "./FactsPanel";
import { MapEditor } from "./maps/MapEditor";
import { ObjectHand } from "./maps/ObjectHand";
import { facts, object, watchRest } from "./now";
import { ObjectPanel } from "./object/ObjectPanel";
import { ProjectionPanel } from "./projection/ProjectionPanel";
import css from "./shape.module.css";

/** The objects of space: what they are, what is done to them, and what that does to their parameters. */
export function ShapePanel() {
  return spaceReady.value ? <Parts /> : null;
}

function Parts() {
  useEffect(watchRest, []);
  return (
    <>
      <ObjectPanel />
      <ObjectHand />
      <Folds />
    </>
  );
}

function Folds() {
  const known = facts.value;
  const dimension = known
    ? known.similarity !== null && known.similarity <= 3
      ? `dimension ${formatNumber(known.similarity, 3)}, unless pieces overlap`
      : `dimension at most ${formatNumber(Math.min(3, known.affinity), 3)}`
    : undefined;
  return (
    <section class={css["solid-folds"]} aria-label="More of the object">
      <Fold title="Its maps" {...(object.value ? { now: mapsNote(object.value) } : {})}>
        <MapEditor key={chosen.value} />
      </Fold>
      <Fold title="Facts" {...(dimension === undefined ? {} : { now: dimension })}>
        <FactsPanel />
      </Fold>
      <Fold title="Shadow on a plane">
        <ProjectionPanel />
      </Fold>
    </section>
  );
}
