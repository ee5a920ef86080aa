/** What the stage's colours are chosen by: fetched when it is first shown. */
import { lazily } from "#ui/lazy";

export const Palettes = lazily(() => import("./palettes/Palettes").then((module) => module.Palettes));
