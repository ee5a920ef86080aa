/** What begins once the first picture is there, and need not be fetched before it. */
import { scheduleExact } from "#compute/exact";
import { recallShapes } from "#tools/morph/shapes/recall";
import { waitForSwipes } from "#ui/swipe";
import { link } from "./actions";
import { beGuided } from "./guide/start";
import { beInstalled } from "./installed";
import { beKept } from "./kept/start";
import { moveBySelf } from "./moving";
import type { readParameters } from "./parameters";
import { beStepped } from "./steps";

type Play = ReturnType<typeof readParameters>["play"];

/** `hash` is what the page was opened with; in a frame of another page there is less. */
export function beginLater(hash: string, embedded: boolean, play: Play): void {
  beInstalled();
  waitForSwipes(document);
  scheduleExact();
  if (!embedded) {
    beStepped(link);
    void beKept(hash);
    beGuided(hash);
    recallShapes();
  }
  if (play === "on" || play === "once") moveBySelf(play);
}
