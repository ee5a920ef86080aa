/** What there is to film of a deformation: its key frames, once through. */

import { curveDrawer } from "#curve/film";
import { pieceColours } from "#document/colours";
import { curved, curveTime } from "#document/curve/curve";
import { bendAt, deformation } from "#document/deform/bend";
import { pictureShown } from "#document/deform/picture";
import { stageTrack } from "#document/framing";
import { standing } from "#document/morph";
import { dark } from "#document/preferences";
import { scene } from "#document/scene";
import type { Films } from "#film/subject";
import { boxAt } from "#geometry/boxes";
import { frameView } from "#stage/frame-view";
import { shownWeights } from "#stage/picture-style";
import { NIGHT, PAPER } from "#style/colours";
import { isDark } from "#style/ground";
import { plainName } from "#ui/files/download";
import { planeDrawer } from "#workers/film/plane-drawer";
import { sheetDrawer } from "#workers/film/sheet-drawer";
import type { Drawer, FrameLook } from "#workers/film/subject";
import { unbent } from "./facts";
import * as messages from "./messages";
import { sway } from "./motion/MotionPanel";

/** What stands there now is taken once: the document may change while the film is made. */
export async function films(): Promise<Films> {
  if (unbent.peek()) throw new Error(messages.shapeSeveralStatesCannot);
  const bent = deformation.peek();
  if (bent.keys.length < 2) {
    return {
      subjects: [],
      nothing: {
        words: messages.nothingMovesYetSingle,
        label: messages.useMotionSway,
        disabled: false,
        run: sway,
      },
    };
  }
  const { a, b, t, colouring } = scene.peek();
  const { seconds } = bent;
  const box = boxAt(stageTrack.peek(), t);
  const maps = standing.peek();
  const photograph = pictureShown.peek();
  const s = curveTime.peek();
  const curve = curved.peek();
  const weights = shownWeights.peek();
  const palettes = { light: pieceColours("light"), dark: pieceColours("dark") };
  const bendOf = (at: number) => bendAt(bent, Math.min(1, at / seconds));

  const drawer = (look: FrameLook, how?: { alone: boolean }): Drawer => {
    const alone = how?.alone ?? false;
    const view = frameView(box, look);
    if (photograph) return sheetDrawer(look, alone, { picture: photograph, parts: bent.parts, view }, bendOf);
    if (curve) return curveDrawer(look, colouring, (at) => ({ s, bend: bendOf(at), view }));
    const lightGround = !isDark(look.ground);
    const palette = palettes[lightGround ? "light" : "dark"];
    return planeDrawer(look, alone, (at) => ({
      maps,
      weights,
      options: { view, colouring, palette, lightGround, bend: bendOf(at) },
    }));
  };

  const shape = photograph ? photograph.name : t < 0.5 ? a.name : b.name;
  return {
    subjects: [
      {
        id: "deform",
        label: messages.deformation,
        name: `${plainName(shape, "shape", 24)}-bent`,
        seconds,
        anyLength: false,
        loops: bent.loop ? ["round", "once", "pingpong"] : ["once", "pingpong"],
        loop: bent.loop ? "round" : "once",
        // Key frames say how fast it goes.
        easing: "linear",
        ground: dark.peek() ? NIGHT : PAPER,
        choosesSmooth: false,
        drawer,
      },
    ],
  };
}
