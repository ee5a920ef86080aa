/** The deformation tool: its side panel, its time strip, and what it lays over the picture. Loaded when it is first asked for. */
export { DeformOverlay } from "./mesh/Overlay";

export function DeformPanel() {
  return <div class="deform-panel" />;
}

export function DeformStrip() {
  return <section class="strip" aria-label="Time" />;
}
