import { useEffect, useMemo, useRef, useState } from "preact/hooks";
import { notify, wordsOf } from "#document/notice";
import type { ExportFormat } from "#wasm/api";
import { type Exchange, loadExchange } from "#wasm/exchange";
import { Button } from "../controls/Button";
import { Segmented } from "../controls/Segmented";
import * as messages from "../messages";
import { Dialog } from "../overlay/Dialog";
import { ChoiceRow } from "../panel/ChoiceRow";
import { Problem } from "../panel/Problem";
import { download, plainName } from "./download";
import css from "./export-dialog.module.css";
import type { NamedMaps } from "./exporting";
import { saidOf } from "./svg";

/** What was chosen last, for the next time. */
let last: ExportFormat = "json";

/** Maps as text: for papers, for other programs, and for Frond again. */
export function ExportDialog({ maps, onClose }: { maps: () => readonly NamedMaps[]; onClose: () => void }) {
  // As they are when it is opened: nothing moves behind it.
  const [systems] = useState(maps);
  const [exchange, setExchange] = useState<Exchange | null>(null);
  const [problem, setProblem] = useState<string | null>(null);
  useEffect(() => {
    loadExchange().then(
      (module) => setExchange(() => module),
      (why) => setProblem(wordsOf(why)),
    );
  }, []);
  return (
    <Dialog title={messages.mapsAsText} about={messages.forPapersAndOther} onClose={onClose}>
      {exchange ? (
        <Texts exchange={exchange} systems={systems} onClose={onClose} />
      ) : (
        <p class="hint" role="status">
          {problem === null ? messages.loading : ""}
        </p>
      )}
      <Problem words={problem} />
    </Dialog>
  );
}

interface TextsProps {
  exchange: Exchange;
  systems: readonly NamedMaps[];
  onClose: () => void;
}

function Texts({ exchange, systems, onClose }: TextsProps) {
  const [at, setAt] = useState(0);
  const system = systems[at] ?? systems[0];
  const solid = system?.maps[0]?.length === 12;
  const formats = exchange.exportFormats().filter(({ space }) => space || !solid);
  const [asked, setAsked] = useState<ExportFormat>(last);
  const format = formats.find(({ id }) => id === asked) ?? formats[0];
  const id = format?.id;
  const written = useMemo(() => write(exchange, system, id), [exchange, system, id]);
  const preview = useRef<HTMLTextAreaElement>(null);
  if (!system || !format) return null;
  const copy = async () => {
    try {
      await navigator.clipboard.writeText(written.text);
      notify({ kind: "info", text: messages.isCopied(system.name, format.label) });
      onClose();
    } catch {
      preview.current?.select();
      notify({ kind: "error", text: messages.browserBlockedCopyingSave });
    }
  };
  return (
    <div class="stack">
      {systems.length > 1 && (
        <ChoiceRow
          label={messages.maps}
          value={String(at)}
          options={systems.map(({ label, name }, i) => ({ value: String(i), label, description: name }))}
          onChange={(next) => setAt(Number(next))}
        />
      )}
      <div class={css["formats"]}>
        <Segmented<ExportFormat>
          label={messages.format}
          value={format.id}
          options={formats.map(({ id, label, about }) => ({ value: id, label, description: about }))}
          onChange={(next) => {
            last = next;
            setAsked(next);
          }}
        />
      </div>
      <p class="hint" aria-live="polite">
        {format.about} {saidOf(written.text)}
      </p>
      {/* What scrolls must be reached by keys. */}
      <textarea
        ref={preview}
        class={css["preview"]}
        readOnly
        spellcheck={false}
        aria-label={messages.nameAs(system.name, format.label)}
        value={beginning(written.text)}
      />
      <Problem words={written.problem} />
      <div class={css["foot"]}>
        <Button
          icon="save"
          disabled={written.problem !== null}
          onClick={() => {
            const blob = new Blob([written.text], { type: "text/plain" });
            download(blob, `frond-${plainName(system.name, "maps", 48)}.${format.extension}`);
            onClose();
          }}
        >
          {messages.saveAs(format.extension)}
        </Button>
        <Button kind="primary" icon="copy" disabled={written.problem !== null} onClick={() => void copy()}>
          {messages.copy}
        </Button>
      </div>
    </div>
  );
}

function write(exchange: Exchange, system: NamedMaps | undefined, format: ExportFormat | undefined) {
  try {
    if (!system || !format) throw new Error(messages.thereNoMapsHere);
    const { name, maps, weights, palette } = system;
    const colours = palette ? maps.map((_, i) => palette[i % palette.length] ?? "") : [];
    const probabilities = weights ? [...weights] : [];
    const whole = { name, maps: [...maps] as never, probabilities, colours };
    return { text: exchange.exportMaps(whole, format), problem: null };
  } catch (why) {
    return { text: "", problem: wordsOf(why) };
  }
}

/** As much of a text as is looked at. */
const MOST_LINES = 120;

function beginning(text: string): string {
  const lines = text.split("\n");
  if (lines.length <= MOST_LINES) return text;
  const more = lines.length - MOST_LINES;
  return messages.moreLines(lines.slice(0, MOST_LINES).join("\n"), more.toLocaleString("en-GB"));
}
