import "./field.css";
import { useRef, useState } from "preact/hooks";
import type { Parsed } from "#format/formula";
import { addStep, formatNumber, keyStep, plainNumber, rangeProblem } from "#format/numbers";
import { useOwnId } from "../id";
import * as messages from "../messages";
import { fieldName, keepTyped, typedAs } from "./typed";

/** Fetched when a field is first entered: on most visits nobody types a formula. */
let formulas: Promise<typeof import("#format/formula")> | null = null;
const fetchFormulas = () => {
  formulas ??= import("#format/formula").catch((problem) => {
    formulas = null;
    throw problem;
  });
  return formulas;
};

export interface NumberFieldProps {
  /** Name in words. */
  label: string;
  /** The symbol of the field, small beside the name: u, v, a .. f. */
  symbol?: string;
  value: number;
  step?: number;
  min?: number;
  max?: number;
  /** Decimals shown; the value itself keeps all it has. */
  digits?: number;
  /** By steps of 1, and without decimals. */
  whole?: boolean;
  unit?: string;
  /** Show only the symbol; the name alone is read out, and is the tooltip. */
  terse?: boolean;
  disabled?: boolean;
  /** Takes a value, or says in a sentence why it cannot be; then the last good value stays. */
  // biome-ignore lint/suspicious/noConfusingVoidType: a caller that cannot refuse returns nothing
  onChange: (value: number, prepared?: unknown) => string | undefined | void;
  /** Finds out what a text means besides its value, before the field gives both on; null: nothing. */
  prepare?: ((text: string, value: number) => Promise<unknown> | null) | undefined;
  /** The formula that the value means; a text that was typed for it goes before. Null: it means what its digits say. */
  formula?: string | null;
  /** The hand leaves the field: a run of steps ends. */
  onDone?: () => void;
  /** Where fields stand close, one place below them tells what is wrong: its id, and what takes the words. */
  problems?: { id: string; tell: (problem: string | null) => void };
}

/** A number that can be typed, as a formula too, or stepped with the arrow keys (shift finer, alt coarser). */
export function NumberField(props: NumberFieldProps) {
  const { label, symbol, value, min, max, whole = false, unit, terse = false } = props;
  const { step = whole ? 1 : 0.01, digits = whole ? 0 : 4 } = props;
  const id = useOwnId("number");
  const [draft, setDraft] = useState<string | null>(null);
  const [problem, setProblem] = useState<string | null>(null);
  const name = fieldName(label, symbol);
  const { formula } = props;
  const typed = formula === null ? undefined : typedAs(name, value);
  const shown = typed ?? formula ?? formatNumber(value, digits);
  const kept = messages.stays(formatNumber(value, digits));
  const tell = (words: string | null) => {
    setProblem(words);
    props.problems?.tell(words === null ? null : `${label}: ${words} ${kept}`);
  };

  // A formula takes a moment to be read: what is there by then is changed.
  const latest = useRef({ props, waits: 0 });
  latest.current.props = props;

  const offer = (next: number, text: string | null, prepared?: unknown) => {
    const refusal = rangeProblem(next, min, max) ?? latest.current.props.onChange(next, prepared) ?? null;
    tell(refusal);
    setDraft(refusal === null ? null : text);
  };
  const take = (read: Parsed, text: string, prepared?: unknown) => {
    if (!read.ok) return tell(read.message);
    keepTyped(name, read.value, text);
    offer(read.value, text, prepared);
  };
  /** Digits are taken at once, formulas when what reads them is there. */
  const commit = (then?: () => void) => {
    const text = draft;
    // Text that was touched but says the same keeps the digits that are not shown.
    if (text === null || text.trim() === shown) {
      revert();
      then?.();
      return;
    }
    const wait = ++latest.current.waits;
    const finish = (read: Parsed, prepared?: unknown) => {
      // Another text may have come in the meantime.
      if (latest.current.waits !== wait) return;
      take(read, text, prepared);
      then?.();
    };
    const prepare = (read: Parsed) => {
      const preparing = read.ok && props.prepare?.(text, read.value);
      if (preparing) void preparing.then((prepared) => finish(read, prepared ?? undefined));
      else finish(read);
    };
    const plain = plainNumber(text);
    if (plain === null)
      fetchFormulas().then(
        ({ parseNumber }) => prepare(parseNumber(text, unit)),
        () => {},
      );
    else prepare({ ok: true, value: plain });
  };
  const revert = () => {
    setDraft(null);
    tell(null);
  };

  return (
    <div class={`field ${problem === null ? "" : "invalid"}`} title={terse ? label : undefined}>
      <label for={id} class={`field-label ${terse && symbol === undefined ? "unseen" : ""}`}>
        {terse ? <span class="unseen">{label}</span> : <span>{label}</span>}
        {symbol !== undefined && (
          <span class="symbol" {...(terse ? { "aria-hidden": true } : {})}>
            {symbol}
          </span>
        )}
      </label>
      <span class="field-box">
        <input
          id={id}
          type="text"
          // Nothing typed is waiting: undo then means the document, not the text.
          data-settled={draft === null}
          role="spinbutton"
          autocomplete="off"
          spellcheck={false}
          enterkeyhint="done"
          value={draft ?? shown}
          disabled={props.disabled ?? false}
          aria-valuenow={value}
          aria-valuemin={min}
          aria-valuemax={max}
          aria-valuetext={`${formatNumber(value, digits)}${unit ?? ""}`}
          aria-invalid={problem !== null}
          aria-describedby={problem === null ? undefined : (props.problems?.id ?? `${id}-problem`)}
          onFocus={(event) => {
            event.currentTarget.select();
            fetchFormulas().catch(() => {});
          }}
          onInput={(event) => setDraft(event.currentTarget.value)}
          onBlur={() => {
            commit(props.onDone);
          }}
          onKeyDown={(event) => {
            if (event.key === "Enter") commit();
            else if (event.key === "Escape" && draft !== null) {
              // Escape takes back the typing here before it closes a dialog around it.
              event.stopPropagation();
              event.preventDefault();
              revert();
            } else if (event.key === "ArrowUp" || event.key === "ArrowDown" || event.key.startsWith("Page")) {
              const by = keyStep(event, step);
              if (by === null) return;
              event.preventDefault();
              const next = addStep((draft === null ? null : plainNumber(draft)) ?? value, by);
              offer(Math.min(max ?? next, Math.max(min ?? next, next)), null);
            }
          }}
        />
        {unit !== undefined && (
          <span class="unit" aria-hidden="true">
            {unit}
          </span>
        )}
      </span>
      {problem !== null && props.problems === undefined && (
        <p class="field-problem" id={`${id}-problem`} role="alert">
          {problem} <span class="kept">{kept}</span>
        </p>
      )}
    </div>
  );
}
