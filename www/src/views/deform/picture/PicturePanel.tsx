import { photograph } from "../../../state/picture";

/** The picture that is bent, and how to take another. */
export function PicturePanel() {
  const shown = photograph.value;
  return (
    <section class="panel-part" aria-labelledby="picture-title">
      <h2 id="picture-title">Your picture</h2>
      {shown && (
        <p>
          {shown.name}, {shown.width} x {shown.height}
        </p>
      )}
      <p class="note">It stays on this device: nothing is uploaded.</p>
    </section>
  );
}
