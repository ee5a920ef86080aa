/** What is not needed for the first picture: fetched when it is asked for, or when there is nothing else to do. */
import { fetchCurves } from "#curve/parts";
import { lazily } from "#ui/lazy";

const evidence = () => import("./evidence/Panel").then((module) => module.EvidencePanel);
const gallery = () => import("./shapes/Gallery").then((module) => module.Gallery);
const maps = () => import("./maps/MapEditor").then((module) => module.MapEditor);

export const EvidencePanel = lazily(evidence);
export const Gallery = lazily(gallery);
export const MapEditor = lazily(maps);

export const fetchAhead = () => Promise.all([fetchCurves(), evidence(), gallery(), maps()]);
