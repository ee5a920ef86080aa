import { MOST_ZOOM } from "#compute/locus/window";
import { IconButton } from "#ui/controls/Button";
import fieldCss from "../field.module.css";
import * as messages from "../messages";
import { full, large, toggleFull, toggleLarge } from "./large";
import { goHome, view, zoomBy } from "./view";

const STEP = 2;

/** What wheel and fingers do, as buttons, in a corner of the square. */
export function ZoomButtons() {
  const { zoom } = view.value;
  return (
    <div class={fieldCss["locus-zoom"]}>
      {large.value && <IconButton icon="close" label={messages.backToPanel} onClick={toggleLarge} />}
      {large.value && (
        <IconButton
          icon="enlarge"
          label={messages.fullScreen}
          command="map-full"
          pressed={full.value}
          onClick={() => void toggleFull()}
        />
      )}
      <IconButton
        icon="add"
        label={messages.zoomIn}
        description={messages.orClickLocusAnd}
        disabled={zoom >= MOST_ZOOM}
        onClick={() => zoomBy(STEP)}
      />
      <IconButton
        icon="remove"
        label={messages.zoomOut}
        disabled={zoom <= 1}
        onClick={() => zoomBy(1 / STEP)}
      />
      <IconButton icon="whole" label={messages.resetView} disabled={zoom <= 1} onClick={goHome} />
    </div>
  );
}
