import { standIn } from "#document/stand-in";
import { lazily } from "#ui/lazy";
import type { MainPainter, PainterState } from "./surface/painter";

interface StandInPictureProps {
  onState: (state: PainterState) => void;
  onPainter: (painter: MainPainter | null) => void;
}

const CurvePicture = lazily(() => import("./curve/picture").then((module) => module.CurvePicture));
const DirectedPicture = lazily(() => import("./directed/picture").then((module) => module.DirectedPicture));

/** What stands in place of the systems, as it is drawn: loaded with the first of its kind. */
export function StandInPicture(props: StandInPictureProps) {
  return standIn.value === "directed" ? <DirectedPicture {...props} /> : <CurvePicture {...props} />;
}
