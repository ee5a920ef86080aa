import { MOST_ZOOM } from "#compute/locus/window";
import { IconButton } from "#ui/controls/Button";
import fieldCss from "../field.module.css";
import { full, large, toggleFull, toggleLarge } from "./large";
import { goHome, view, zoomBy } from "./view";

const STEP = 2;

/** What wheel and fingers do, as buttons, in a corner of the square. */
export function ZoomButtons() {
  const { zoom } = view.value;
  return (
    <div class={fieldCss["locus-zoom"]}>
      {large.value && <IconButton icon="close" label="Back into the panel" onClick={toggleLarge} />}
      {large.value && (
        <IconButton
          icon="enlarge"
          label="Full screen"
          command="map-full"
          pressed={full.value}
          onClick={() => void toggleFull()}
        />
      )}
      <IconButton
        icon="add"
        label="Nearer"
        description="or press the map and turn the wheel, or press twice"
        disabled={zoom >= MOST_ZOOM}
        onClick={() => zoomBy(STEP)}
      />
      <IconButton icon="remove" label="Farther" disabled={zoom <= 1} onClick={() => zoomBy(1 / STEP)} />
      <IconButton icon="whole" label="All of the map" disabled={zoom <= 1} onClick={goHome} />
    </div>
  );
}
