import { useEffect, useState } from "preact/hooks";
import { directedPicture, type PictureSize } from "#stage/directed/thumb";
import { stageStyle } from "#stage/picture-style";
import { Thumbnail } from "#ui/shapes/Thumbnail";
import type { DirectedIfs } from "#wasm/api";

const SIZE: PictureSize = { width: 160, height: 104 };

/** A small picture of a shape. Whatever holds it says what it shows. */
export function DirectedThumb({ states }: Pick<DirectedIfs, "states">) {
  const [bitmap, setBitmap] = useState<ImageBitmap | null>(null);
  const { colouring, palette } = stageStyle.value;
  useEffect(() => {
    const end = new AbortController();
    directedPicture({ states }, SIZE, { colouring, palette }, end.signal).then(
      (made) => {
        if (!end.signal.aborted) setBitmap(made);
      },
      () => {
        // Without a picture the card still has its name.
      },
    );
    return () => end.abort();
  }, [states, colouring, palette]);
  return <Thumbnail bitmap={bitmap} />;
}
