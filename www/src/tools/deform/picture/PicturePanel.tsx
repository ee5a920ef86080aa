import { useEffect, useState } from "preact/hooks";
import { ownPicture, type Photograph, photograph } from "#document/deform/picture";
import { Button } from "#ui/controls/Button";
import { FileButton } from "#ui/files/FileButton";
import { SubjectCard } from "#ui/shapes/SubjectCard";
import { Thumbnail } from "#ui/shapes/Thumbnail";
import * as messages from "../messages";
import css from "./picture.module.css";
import { takeFile, takeSample } from "./take";

const ACCEPT = "image/png,image/jpeg,image/webp,image/avif,image/gif,image/bmp";

/** The picture that is bent, and how to take another. */
export function PicturePanel() {
  const shown = photograph.value;
  return (
    <section class={`${css["picture-panel"]} stack`} aria-label={messages.yourPicture}>
      <SubjectCard
        picture={<Thumbnail bitmap={useThumbnail(shown)} />}
        name={shown?.name ?? messages.drawingSample}
        about={shown ? messages.pixels(shown.width, shown.height) : ""}
      />
      <div class={css["picture-buttons"]}>
        <FileButton
          label={messages.pictureFile}
          accept={ACCEPT}
          onFile={(file) => void takeFile(file, file.name)}
        >
          {messages.choosePicture}
        </FileButton>
        {ownPicture.value && (
          <Button kind="quiet" onClick={takeSample}>
            {messages.backToSample}
          </Button>
        )}
      </div>
      <p class="hint">{messages.orDropOneOn}</p>
    </section>
  );
}

const THUMBNAIL = 160;

/** A small copy, made aside. */
function useThumbnail(shown: Photograph | null): ImageBitmap | null {
  const [bitmap, setBitmap] = useState<ImageBitmap | null>(null);
  useEffect(() => {
    if (!shown) return;
    let wanted = true;
    const { pixels, width, height } = shown;
    const factor = Math.min(1, THUMBNAIL / Math.max(width, height));
    createImageBitmap(new ImageData(pixels, width, height), {
      resizeWidth: Math.max(1, Math.round(width * factor)),
      resizeHeight: Math.max(1, Math.round(height * factor)),
      resizeQuality: "medium",
    }).then(
      (small) => {
        if (wanted) setBitmap(small);
      },
      // A card without its picture still has its name.
      () => {},
    );
    return () => {
      wanted = false;
    };
  }, [shown]);
  return bitmap;
}
