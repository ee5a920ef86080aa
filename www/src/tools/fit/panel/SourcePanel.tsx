import { Button } from "#ui/controls/Button";
import { FileButton } from "#ui/files/FileButton";
import type { Grown } from "#workers/fit/curve";
import fitCss from "../fit.module.css";
import { ToShelf } from "../kept/KeptPanel";
import { takeSeries } from "../series";
import { prepared, SEEDS } from "../work/outline";
import { former, type Source, source, takeFile, takeFormer, takeSource } from "../work/source";
import { ACCEPT, READS } from "./formats";

const take = (file: File) => void takeFile(file, file.name, takeSeries);

/** What is fitted, and how to take something else. */
export function SourcePanel() {
  const now = source.value;
  const back = former.value;
  return (
    <section class="stack" aria-label="What is fitted">
      <div class={fitCss["source-card"]} data-testid="source">
        <span class={fitCss["source-name"]}>{now.name}</span>
        <span class={fitCss["source-about"]}>{aboutOf(now, prepared.value?.points.length ?? null)}</span>
      </div>
      <div class={fitCss["source-buttons"]}>
        <FileButton kind="primary" label="Photograph or outline file" accept={ACCEPT} onFile={take}>
          Choose a photograph or outline
        </FileButton>
        <ToShelf />
        {back && back.kind !== "grown" && (
          <Button kind="quiet" icon="back" onClick={takeFormer}>
            Back to {back.name.length > 24 ? `${back.name.slice(0, 22)}…` : back.name}
          </Button>
        )}
      </div>
      <p class="hint">
        Or drop a file anywhere, or paste it: {READS}. It stays on this page. A link holds the fit, but not
        the file.
      </p>
      <Examples />
    </section>
  );
}

const EXAMPLES: readonly { grown: Grown; name: string; about: string }[] = [
  { grown: "sugar-maple", name: "Maple leaf", about: "Five lobes with pointed teeth and round bays" },
  { grown: "white-oak", name: "Oak leaf", about: "Round lobes and narrow bays" },
  { grown: "island", name: "Island", about: "A coast that is rough however near it is seen" },
  { grown: "noisy", name: "Noisy leaf", about: "A maple leaf, badly measured: try the smoothing" },
];

/** Leaves that are grown by program, each time another one. */
function Examples() {
  const now = source.value;
  return (
    <div class={`${fitCss["examples"]} stack`}>
      <span class="row-name" id="examples-name">
        Or one grown here
      </span>
      <ul class={fitCss["examples-list"]} aria-labelledby="examples-name">
        {EXAMPLES.map(({ grown, name, about }) => {
          const here = now.kind === "grown" && now.grown === grown;
          return (
            <li key={grown}>
              <Button
                pressed={here}
                description={here ? `${about}. Press again to grow another` : about}
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
  const points = numbers === null ? "" : `${(numbers / 2).toLocaleString("en-GB")} points`;
  switch (now.kind) {
    case "picture": {
      const { width, height } = now.picture.original;
      const size = `${width.toLocaleString("en-GB")} × ${height.toLocaleString("en-GB")} pixels`;
      return points ? `${size}, outline of ${points}` : size;
    }
    case "kept":
      return now.origin
        ? `One of your fits, with its outline of ${points}`
        : "A fit without what it was made from";
    case "outlines":
      return now.outlines.length > 1 ? `${now.outlines.length} outlines, this one of ${points}` : points;
    case "grown":
      return points ? `Grown by program, ${points}` : "Grown by program";
  }
}
