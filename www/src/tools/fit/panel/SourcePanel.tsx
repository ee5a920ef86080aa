import { Button } from "#ui/controls/Button";
import { FileButton } from "#ui/files/FileButton";
import type { Grown } from "#workers/fit/curve";
import fitCss from "../fit.module.css";
import { ToShelf } from "../kept/KeptPanel";
import { takeSeries } from "../open";
import { prepared, SEEDS } from "../work/outline";
import { former, type Source, source, takeFile, takeFormer, takeSource } from "../work/source";
import * as messages from "./messages";

/** What can be chosen, dropped or pasted: for the file dialog, and in words. */
export const ACCEPT =
  "image/png,image/jpeg,image/webp,image/avif,image/gif,image/bmp,image/svg+xml,.svg,.csv,.tsv,.txt,.tps,.json,.geojson,.topojson,text/csv,application/json,application/geo+json";

export const READS = messages.reads;

const take = (file: File) => void takeFile(file, file.name, takeSeries);

/** What is fitted, and how to take something else. */
export function SourcePanel() {
  const now = source.value;
  const back = former.value;
  return (
    <section class="stack" aria-label={messages.source}>
      <div class={fitCss["source-card"]} data-testid="source">
        <span class={fitCss["source-name"]}>{now.name}</span>
        <span class={fitCss["source-about"]}>{aboutOf(now, prepared.value?.points.length ?? null)}</span>
      </div>
      <div class={fitCss["source-buttons"]}>
        <FileButton kind="primary" label={messages.photoOrOutlineFile} accept={ACCEPT} onFile={take}>
          {messages.choosePhotoOrOutline}
        </FileButton>
        <ToShelf />
        {back && back.kind !== "grown" && (
          <Button kind="quiet" icon="back" onClick={takeFormer}>
            {messages.backTo(back.name.length > 24 ? `${back.name.slice(0, 22)}…` : back.name)}
          </Button>
        )}
      </div>
      <p class="hint">{messages.orDrop(READS)}</p>
      <Examples />
    </section>
  );
}

const EXAMPLES: readonly { grown: Grown; name: string; about: string }[] = [
  { grown: "sugar-maple", name: messages.mapleLeaf, about: messages.fiveLobesWithPointed },
  { grown: "white-oak", name: messages.oakLeaf, about: messages.roundLobesAndNarrow },
  { grown: "island", name: messages.island, about: messages.coastRoughAtEvery },
  { grown: "noisy", name: messages.noisyLeaf, about: messages.badlyMeasuredMapleLeaf },
];

/** Leaves that are grown by program, each time another one. */
function Examples() {
  const now = source.value;
  return (
    <div class={`${fitCss["examples"]} stack`}>
      <span class="row-name" id="examples-name">
        {messages.orOneGrownHere}
      </span>
      <ul class={fitCss["examples-list"]} aria-labelledby="examples-name">
        {EXAMPLES.map(({ grown, name, about }) => {
          const here = now.kind === "grown" && now.grown === grown;
          return (
            <li key={grown}>
              <Button
                pressed={here}
                description={here ? messages.growAnother(about) : about}
                onClick={() =>
                  takeSource({ kind: "grown", name, grown, seed: here ? now.seed + 1 : SEEDS[grown] })
                }
              >
                {here && now.seed > SEEDS[grown] ? `${name} ${now.seed - SEEDS[grown] + 1}` : name}
              </Button>
            </li>
          );
        })}
      </ul>
    </div>
  );
}

function aboutOf(now: Source, numbers: number | null): string {
  const points = numbers === null ? "" : messages.points((numbers / 2).toLocaleString("en-GB"));
  switch (now.kind) {
    case "picture": {
      const { width, height } = now.picture.original;
      const size = messages.pixels(width.toLocaleString("en-GB"), height.toLocaleString("en-GB"));
      return points ? messages.sizeAndOutline(size, points) : size;
    }
    case "kept":
      return now.origin ? messages.keptWithOutline(points) : messages.fitWithoutSource;
    case "outlines":
      return now.outlines.length > 1 ? messages.severalOutlines(now.outlines.length, points) : points;
    case "grown":
      return points ? messages.grownBy(points) : messages.generated;
  }
}
