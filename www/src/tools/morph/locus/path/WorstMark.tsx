import { along } from "#compute/results";
import { pathPoints } from "#document/morph";
import { percent } from "#format/path-words";
import { shareWords } from "#format/verdict";
import { uvAt } from "#geometry/path";
import * as messages from "../messages";
import { shownWindow } from "../view/view";
import { place } from "./way";

/** Where the gap is widest along the path. It takes no hold: handles may lie under it. */
export function WorstMark() {
  const worst = along.value?.worst;
  if (!worst) return null;
  const [x, y] = place(uvAt(pathPoints.value, worst.t), shownWindow.value);
  if (!(x >= 0 && x <= 1 && y >= 0 && y <= 1)) return null;
  return (
    <span
      class="worst-mark"
      style={{ left: `${100 * x}%`, top: `${100 * y}%` }}
      role="img"
      aria-label={messages.worstAt(shareWords(worst.gap), percent(worst.t))}
    />
  );
}
