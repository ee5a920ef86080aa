/** What is not needed for the first picture: fetched when it is asked for, or when there is nothing else to do. */
import { fetchCurves } from "#curve/parts";
import { lazily } from "#ui/lazy";

const causes = () => import("./locus/view/Causes").then((module) => module.Causes);
const evidence = () => import("./evidence/Panel").then((module) => module.MorphEvidence);
const gallery = () => import("./shapes/Gallery").then((module) => module.Gallery);
const maps = () => import("./maps/MapEditor").then((module) => module.MapEditor);
const motion = () => import("./MotionPanel").then((module) => module.MotionPanel);
const pairs = () => import("./pairs/Pairs").then((module) => module.PairsDetail);
const pairWords = () => import("./pairs/PairWords").then((module) => module.PairWords);
const wayElse = () => import("./locus/path/WayElse").then((module) => module.WayElse);
const familyLines = () => import("./locus/families/FamilyLines").then((module) => module.FamilyLines);
const familyStrip = () => import("./locus/families/FamilyStrip").then((module) => module.FamilyStrip);
const orbitOverlay = () => import("./orbit/OrbitOverlay").then((module) => module.OrbitOverlay);
const orbitPanel = () => import("./orbit/OrbitPanel").then((module) => module.OrbitPanel);
const otherWays = () => import("./locus/path/OtherWays").then((module) => module.OtherWays);
const tickOrigins = () => import("./locus/view/TickOrigins").then((module) => module.TickOrigins);
const standIn = () => import("./StandIn").then((module) => module.StandIn);
const toBoundary = () => import("./locus/view/ToBoundary").then((module) => module.ToBoundary);
const familyNotes = () => import("./locus/families/FamilyNotes").then((module) => module.FamilyNotes);

export const Causes = lazily(causes);
export const MorphEvidence = lazily(evidence);
export const Gallery = lazily(gallery);
export const MapEditor = lazily(maps);
export const MotionPanel = lazily(motion);
export const Pairs = lazily(pairs);
export const PairWords = lazily(pairWords);
export const WayElse = lazily(wayElse);
export const FamilyLines = lazily(familyLines);
export const FamilyStrip = lazily(familyStrip);
export const OrbitOverlay = lazily(orbitOverlay);
export const OrbitPanel = lazily(orbitPanel);
export const OtherWays = lazily(otherWays);
export const TickOrigins = lazily(tickOrigins);
export const StandIn = lazily(standIn);
export const ToBoundary = lazily(toBoundary);
export const FamilyNotes = lazily(familyNotes);

export const fetchAhead = () =>
  Promise.all([
    fetchCurves(),
    causes(),
    evidence(),
    gallery(),
    maps(),
    motion(),
    pairs(),
    pairWords(),
    wayElse(),
    familyLines(),
    familyNotes(),
    familyStrip(),
    orbitOverlay(),
    orbitPanel(),
    otherWays(),
    standIn(),
    tickOrigins(),
    toBoundary(),
  ]);
