import type { ComponentChildren } from "preact";
import { useOwnId } from "#ui/id";
import { SliderControl } from "../../kit/frame/control";
import type { Notation } from "../../kit/notation/tex";
import css from "./choices.module.css";
import type { Prediction } from "./prediction";

export interface Choice<T extends string> {
  value: T;
  label: ComponentChildren;
  /** What is said to whoever chose it where it is not so: what would show it. */
  wrong?: string;
}

export interface ChoicesProps<T extends string> {
  ask: ComponentChildren;
  options: readonly Choice<T>[];
  prediction: Prediction<T>;
  /** Which of them is so; null while it is still being worked out. */
  truth: T | null;
}

const LONGEST = "your guess";

/** What is said beside an option once the truth is shown. */
function markOf(guessed: boolean, so: boolean): string {
  if (so) return guessed ? "right" : "this is it";
  return guessed ? "your guess" : "";
}

/** A question with a few answers, one to a line. What was guessed and what is so are marked in words. */
export function Choices<T extends string>({ ask, options, prediction, truth }: ChoicesProps<T>) {
  const name = useOwnId("guess");
  const { guess, shown } = prediction;
  return (
    <fieldset class={css["choices"]}>
      <legend>{ask}</legend>
      {options.map(({ value, label }) => {
        const so = shown && value === truth;
        return (
          <label key={value} class={`${css["option"]} ${so ? css["so"] : ""}`}>
            <input
              type="radio"
              name={name}
              value={value}
              checked={value === guess}
              disabled={shown && value !== guess}
              onChange={() => prediction.say(value)}
            />
            <span>{label}</span>
            {/* Its room is kept, so that nothing moves when it comes. */}
            <span class={css["option-mark"]} aria-hidden={!shown} data-kept={shown ? undefined : ""}>
              {shown ? markOf(value === guess, so) : LONGEST}
            </span>
          </label>
        );
      })}
    </fieldset>
  );
}

type ReplyProps<T extends string> = Pick<ChoicesProps<T>, "options" | "prediction" | "truth">;

/** The first words of an answer: to whoever saw it, and to whoever chose something else. */
export function Reply<T extends string>({ options, prediction: { guess }, truth }: ReplyProps<T>) {
  if (guess === truth) return <p>You guessed right.</p>;
  const wrong = options.find(({ value }) => value === guess)?.wrong;
  return wrong === undefined ? null : <p>{wrong}</p>;
}

interface GuessProps {
  ask: ComponentChildren;
  /** The name of the slider. */
  label: string;
  symbol?: Notation;
  min: number;
  max: number;
  step: number;
  format: (value: number) => string;
  prediction: Prediction<number>;
  truth: number | null;
  /** Whether no picture shows what it is set to: then paper has no use for it. */
  undrawn?: boolean;
}

/** A question whose answer is a number, to be dragged to. Afterwards the truth is a mark on the same track. */
export function Guess(props: GuessProps) {
  const { ask, label, symbol, min, max, step, format, prediction, truth, undrawn } = props;
  const { guess, shown } = prediction;
  const value = guess ?? min;
  const at = truth === null ? null : Math.min(1, Math.max(0, (truth - min) / (max - min)));
  const told = shown && truth !== null;
  return (
    <fieldset
      class={`${css["choices"]} ${css["guess"]}`}
      disabled={shown}
      data-undrawn={undrawn ? "" : undefined}
    >
      <legend>{ask}</legend>
      <SliderControl
        label={shown ? "Your guess" : label}
        name={label}
        symbol={symbol}
        range={[min, max]}
        step={step}
        whole={step === 1}
        value={value}
        text={format(value)}
        valueText={`${format(value)}${told ? `; it is ${format(truth)}` : ""}`}
        onChange={prediction.say}
        below={
          <p class={css["truth-name"]} aria-hidden="true">
            {told && at !== null && (
              <span style={{ left: `${100 * at}%` }} data-end={at > 0.85 ? "" : undefined}>
                {format(truth)}
              </span>
            )}
          </p>
        }
      >
        {told && at !== null && <span class={css["truth-mark"]} style={{ left: `${100 * at}%` }} />}
      </SliderControl>
    </fieldset>
  );
}
