/** Time in space: its strip, what of it is in the panel, and its keys on the keyboard. */

export { TIME_SHORTCUTS } from "./shortcuts";
export { TimePanel } from "./TimePanel";
export { TimeStrip } from "./TimeStrip";
