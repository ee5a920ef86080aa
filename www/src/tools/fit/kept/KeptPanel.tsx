import { useEffect, useMemo, useState } from "preact/hooks";
import { curveBoxAt } from "#document/curve/curve";
import type { Use } from "#document/fit";
import { type KeptFit, MOST_FITS, MOST_PIXELS } from "#document/kept/fits";
import { LONGEST_NAME } from "#document/kept/rows";
import { percent } from "#format/nearness";
import { whenWords } from "#format/when";
import { curveThumb } from "#stage/curve/thumb";
import { stageStyle } from "#stage/picture-style";
import { Button } from "#ui/controls/Button";
import { KeptRow, KeptRows } from "#ui/kept/KeptRow";
import { Menu } from "#ui/overlay/Menu";
import { Thumbnail } from "#ui/shapes/Thumbnail";
import type { Curve, Fit } from "#wasm/api";
import { rough } from "#wasm/curve";
import fitCss from "../fit.module.css";
import * as messages from "../messages";
import { cutting } from "../stage/layers";
import { bendPhotograph, takeKept } from "../use";
import { numbersOf } from "../work/outline";
import {
  canKeep,
  fitOf,
  isKept,
  keepFit,
  openKept,
  pinKept,
  readShelf,
  removeKept,
  renameKept,
  rows,
  trouble,
} from "./shelf";

const ABOUT = messages.keptFits(MOST_FITS, MOST_PIXELS);

/** As many as are seen at once. */
const FEW = 5;

/** The fits that a person keeps. */
export function KeptPanel() {
  const [all, setAll] = useState(false);
  useEffect(() => void readShelf(), []);
  if (cutting.value) return null;
  const there = rows.value ?? [];
  const shown = all ? there : there.slice(0, FEW);
  return (
    <section class="stack" aria-label={messages.yourFits} id={SHELF_ID} tabIndex={-1}>
      <div class="section-head">
        <h2>{messages.yourFits}</h2>
        <Button
          icon={isKept.value ? "check" : "save"}
          disabled={!canKeep.value || isKept.value}
          onClick={() => void keepFit()}
        >
          {isKept.value ? messages.saved : messages.saveThisFit}
        </Button>
      </div>
      {trouble.value !== null && (
        <p class={fitCss["fit-problem"]} role="status">
          {trouble.value}
        </p>
      )}
      {there.length > 0 && (
        <KeptRows>
          {shown.map((row) => (
            <Entry key={row.id} row={row} />
          ))}
        </KeptRows>
      )}
      {there.length > FEW && (
        <Button kind="quiet" onClick={() => setAll(!all)}>
          {all ? messages.showFewer : messages.showAllOf(there.length)}
        </Button>
      )}
      <p class="hint">{there.length === 0 ? messages.keptFitsBenefit(ABOUT) : ABOUT}</p>
    </section>
  );
}

const SHELF_ID = "your-fits";

/** The way to the shelf from where one chooses what to fit. */
export function ToShelf() {
  const count = rows.value?.length ?? 0;
  if (count === 0) return null;
  const go = () => {
    const shelf = document.getElementById(SHELF_ID);
    shelf?.scrollIntoView({ block: "start" });
    shelf?.focus({ preventScroll: true });
  };
  return (
    <Button kind="quiet" icon="down" onClick={go}>
      {messages.yourFitsOf(count)}
    </Button>
  );
}

function Entry({ row }: { row: KeptFit }) {
  const [naming, setNaming] = useState(false);
  const { fragment, photograph } = row;
  const read = useMemo(() => fitOf(fragment), [fragment]);
  const shape = read && { ...read.shape, name: row.name || read.shape.name };
  const take = (to: Use) => () => {
    if (shape) takeKept(shape, photograph, to);
  };
  return (
    <KeptRow
      small
      name={row.name}
      picture={<Thumbnail bitmap={useThumb(read?.shape.curve ?? null)} />}
      about={
        <>
          {read ? aboutWords(row, read.fit) : messages.thisVersionFrondCannot}
          <br />
          {whenWords(row.time)}
          {row.pinned && messages.pinnedAside}
        </>
      }
      onOpen={read ? () => openKept(row, read.fit) : undefined}
      naming={naming}
      longest={LONGEST_NAME}
      onName={(name) => void renameKept(row, name)}
      onNamed={() => setNaming(false)}
    >
      <Menu
        label={messages.moreFor(row.name)}
        items={[
          ...(shape
            ? [
                { label: messages.useAs, onSelect: take("a") },
                { label: messages.useAsB, onSelect: take("b") },
                { label: messages.deform, onSelect: take("bent") },
                ...(photograph
                  ? [
                      {
                        label: messages.deformPhoto,
                        onSelect: () => void bendPhotograph(shape.name, shape.curve, photograph),
                      },
                    ]
                  : []),
              ]
            : []),
          { label: messages.rename, onSelect: () => setNaming(true) },
          { label: row.pinned ? messages.unpin : messages.pin, onSelect: () => void pinKept(row) },
          { label: messages.remove, onSelect: () => void removeKept(row) },
        ]}
      />
    </KeptRow>
  );
}

const SIZE = { width: 76, height: 56 };

function useThumb(curve: Curve | null): ImageBitmap | null {
  const { palette } = stageStyle.value;
  return useMemo(() => {
    if (!curve) return null;
    try {
      const morph = new rough.CurveMorph(curve, null);
      try {
        return curveThumb(morph, 0, curveBoxAt(morph, 0), SIZE, palette);
      } finally {
        morph.free();
      }
    } catch {
      // Without a picture it can still be opened.
      return null;
    }
  }, [curve, palette]);
}

/** How near a fit is and what it takes. */
function aboutWords({ rms, bytes }: Pick<KeptFit, "rms" | "bytes">, { curve }: Fit): string {
  const parts = [
    ...(curve ? [messages.numbers(numbersOf(curve.curve))] : []),
    messages.bytes(bytes.toLocaleString("en-GB")),
  ];
  return (rms === null ? parts : [messages.error(percent(rms)), ...parts]).join(" · ");
}
