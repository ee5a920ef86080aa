import { standIn } from "#document/stand-in";
import { evidenceOpen } from "#stage/evidence/shown";
import { MapOverlay } from "#stage/stage";
import type { ToolEntry } from "#stage/tool";
import { commands, timeline } from "./commands";
import { orbitOpen } from "./dialogs";
import { MorphPanel } from "./index";
import { fetchAhead, MorphEvidence, OrbitOverlay, StandIn } from "./later";
import { MorphChip } from "./MorphChip";
import * as messages from "./messages";
import { namedMaps } from "./parts";
import { MorphStrip } from "./strip/MorphStrip";

export const morph: ToolEntry = {
  id: "morph",
  label: messages.morph2,
  title: messages.frondMorphOneFractal,
  side: messages.shapesAndPath,
  tool: {
    Overlay: () => (
      <>
        <MapOverlay />
        {orbitOpen.value && !standIn.value && <OrbitOverlay />}
      </>
    ),
    Verdict: () => (standIn.value ? <StandIn part="chip" /> : <MorphChip />),
    Evidence: () => (standIn.value ? <StandIn part="evidence" /> : evidenceOpen.value && <MorphEvidence />),
    Panel: MorphPanel,
    Strip: MorphStrip,
    timeline,
    commands: () => commands,
    films: () => import("./film").then((module) => module.films()),
    maps: namedMaps,
  },
  fetchAhead,
};
