import { NumberField } from "#ui/controls/NumberField";
import css from "./graph.module.css";
import * as messages from "./messages";

interface DomainFieldsProps {
  domain: readonly [from: number, to: number];
  /** Where all of the graph lies. */
  within: readonly [from: number, to: number];
  /** Takes one end, or says why it cannot be. */
  onChange: (end: 0 | 1, t: number) => string | undefined;
  onDone?: () => void;
}

/** The part of a graph that a piece copies. */
export function DomainFields({ domain, within: [from, to], onChange, onDone = () => {} }: DomainFieldsProps) {
  return (
    <div class={css["piece-domain"]}>
      {([0, 1] as const).map((end) => (
        <NumberField
          key={end}
          label={end === 0 ? messages.copiesFrom : messages.to}
          symbol={end === 0 ? "α" : "β"}
          value={domain[end]}
          min={from}
          max={to}
          step={0.01 * (to - from)}
          onChange={(t) => onChange(end, t)}
          onDone={onDone}
        />
      ))}
    </div>
  );
}
