import { formatNumber } from "#format/numbers";
import { IconButton } from "#ui/controls/Button";
import css from "../graph/graph.module.css";
import * as messages from "../messages";

interface ZoomButtonsProps {
  /** How many times larger than the whole it is shown. */
  zoom: number;
  zoomAbout: (factor: number) => void;
  showAll: () => void;
}

/** How near one is, and the ways nearer, farther, and back to the whole. */
export function ZoomButtons({ zoom, zoomAbout, showAll }: ZoomButtonsProps) {
  return (
    <div class={css["graph-zoom"]}>
      {zoom > 1.01 && <span class="readout number">{formatNumber(zoom, zoom < 10 ? 1 : 0)}×</span>}
      <IconButton kind="quiet" icon="remove" label={messages.zoomOut} onClick={() => zoomAbout(1 / 1.6)} />
      <IconButton kind="quiet" icon="add" label={messages.zoomIn} onClick={() => zoomAbout(1.6)} />
      <IconButton
        kind="quiet"
        icon="whole"
        label={messages.resetView}
        disabled={Math.abs(zoom - 1) < 1e-6}
        onClick={showAll}
      />
    </div>
  );
}
