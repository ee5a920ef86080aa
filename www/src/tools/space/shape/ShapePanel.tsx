import { useEffect } from "preact/hooks";
import { chosen, spaceReady } from "#document/space/space";
import { formatNumber } from "#format/numbers";
import { Fold } from "#ui/panel/Fold";
import { mapsNote } from "#ui/shapes/ShapeGrid";
import { FactsPanel } from "./FactsPanel";
import { MapEditor } from "./maps/MapEditor";
import { ObjectHand } from "./maps/TwelveFields";
import * as messages from "./messages";
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
      ? messages.dimensionUnless(formatNumber(known.similarity, 3))
      : messages.dimensionAtMost(formatNumber(Math.min(3, known.affinity), 3))
    : undefined;
  return (
    <section class={css["solid-folds"]} aria-label={messages.moreAboutObject}>
      <Fold title={messages.maps} {...(object.value ? { now: mapsNote(object.value) } : {})}>
        <MapEditor key={chosen.value} />
      </Fold>
      <Fold title={messages.facts} {...(dimension === undefined ? {} : { now: dimension })}>
        <FactsPanel />
      </Fold>
      <Fold title={messages.shadowOnPlane}>
        <ProjectionPanel />
      </Fold>
    </section>
  );
}
