/** The picture on the stage as a file. */

import { curveDrawer } from "#curve/film";
import { directedDrawer } from "#directed/film";
import { curveMorph, curveTime } from "#document/curve/curve";
import { photographsSeen } from "#document/curve/photographs";
import { bend, deformation } from "#document/deform/bend";
import { pictureShown } from "#document/deform/picture";
import { directedWay } from "#document/directed/directed";
import { selection, shown, shownColours } from "#document/morph";
import { dark } from "#document/preferences";
import { scene } from "#document/scene";
import { endsOf } from "#document/stand-in";
import { tool } from "#document/tool";
import { stepsSubject } from "#film/steps";
import type { Still } from "#film/subject";
import { shownWeights } from "#stage/picture-style";
import { effectiveView, stageSize } from "#stage/view";
import { NIGHT, PAPER } from "#style/colours";
import { isDark } from "#style/ground";
import { download, plainName } from "#ui/files/download";
import { whileDrawn } from "#ui/files/saving";
import { makePicture } from "#workers/film/picture";
import { planeDrawer } from "#workers/film/plane-drawer";
import { sheetDrawer } from "#workers/film/sheet-drawer";
import type { Drawer, FrameLook } from "#workers/film/subject";
import * as messages from "./messages";

/** What the stage that tools share shows now, to be drawn at any size. */
export async function stageStill(): Promise<Still> {
  const stage = stageSize.peek();
  const seen = effectiveView.peek();
  const { colouring, t } = scene.peek();
  const photograph = pictureShown.peek();
  const curve = photograph ? null : curveMorph.peek();
  const way = photograph ? null : directedWay.peek();
  const bent = selection.peek() ? null : bend.peek();
  const maps = shown.peek();
  const weights = shownWeights.peek();
  const { parts } = deformation.peek();
  const s = curveTime.peek();
  const photographs = tool.peek() === "morph" ? photographsSeen.peek() : null;
  const ground = dark.peek() ? NIGHT : PAPER;

  const drawer = (look: FrameLook, how?: { alone: boolean }): Drawer => {
    const alone = how?.alone ?? false;
    // All that is on the stage, and more on two sides where the picture has another shape.
    const larger = Math.min(look.width / Math.max(1, stage.width), look.height / Math.max(1, stage.height));
    const view = { ...seen, scale: seen.scale * larger };
    if (photograph) return sheetDrawer(look, alone, { picture: photograph, parts, view }, () => bent);
    if (curve) return curveDrawer(look, colouring, () => ({ s, bend: bent, view }), photographs);
    if (way) return directedDrawer(look, way, colouring, () => ({ t, view }));
    const lightGround = !isDark(look.ground);
    const palette = shownColours(lightGround ? "light" : "dark");
    const options = { view, colouring, palette, lightGround, ...(bent ? { bend: bent } : {}) };
    return planeDrawer(look, alone, () => ({ maps, weights, options }));
  };

  return {
    subject: {
      id: "still",
      label: messages.picture,
      name: pictureName(),
      seconds: 1,
      anyLength: false,
      loops: ["once"],
      loop: "once",
      ground,
      easing: null,
      choosesSmooth: false,
      drawer,
    },
    at: 0,
    stage,
    inStrips: !curve && !way && (photograph !== null || colouring !== "density"),
    steps: curve || way || photograph || bent ? null : stepsSubject(maps, pictureName(), ground),
  };
}

/** The whole address of a document, for a picture to carry; null where no link can hold it. */
export function addressOf(fragment: string | null): string | null {
  return fragment === null ? null : `${location.origin}${location.pathname}#${fragment}`;
}

const LONG_SIDE = 2400;

/** The picture as it stands on the stage, larger, complete, on a transparent ground, with its link. */
export async function savePicture(fragment: string | null): Promise<void> {
  await whileDrawn("save", async (signal) => {
    const { subject, at, stage } = await stageStill();
    const larger = LONG_SIDE / Math.max(stage.width, stage.height, 1);
    const width = Math.max(1, Math.round(stage.width * larger));
    const height = Math.max(1, Math.round(stage.height * larger));
    const settings = { width, height, ground: null, link: addressOf(fragment) };
    const { bytes, type } = await makePicture({ subject, at, settings, smooth: true }, signal, () => {});
    download(new Blob([bytes], { type }), `frond-${subject.name}.png`);
  });
}

function pictureName(): string {
  const { a, b } = endsOf(scene.peek());
  const plain = (name: string) => plainName(name, "shape", 24);
  return `${plain(a.name)}-${plain(b.name)}-${scene.peek().t.toFixed(2)}`;
}
