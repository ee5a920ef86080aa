import { CurveChip, CurveEvidence } from "#curve/parts";
import { curved } from "#document/curve/curve";
import { evidenceOpen } from "#stage/evidence-shown";
import { MapOverlay } from "#stage/stage";
import type { ToolEntry } from "#stage/tool";
import { commands, timeline } from "./commands";
import { MorphPanel } from "./index";
import { EvidencePanel, fetchAhead } from "./later";
import { namedMaps } from "./parts";
import { MorphStrip } from "./strip/MorphStrip";
import { VerdictChip } from "./VerdictChip";

export const morph: ToolEntry = {
  id: "morph",
  label: "Morph",
  title: "Frond: morph one fractal into another",
  side: "Shapes and path",
  tool: {
    Overlay: MapOverlay,
    Verdict: () => (curved.value ? <CurveChip /> : <VerdictChip />),
    Evidence: () => (curved.value ? <CurveEvidence /> : evidenceOpen.value && <EvidencePanel />),
    Panel: MorphPanel,
    Strip: MorphStrip,
    timeline,
    commands: () => commands,
    films: () => import("./film").then((module) => module.films()),
    maps: namedMaps,
  },
  fetchAhead,
};
