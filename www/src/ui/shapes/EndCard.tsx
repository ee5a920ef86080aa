import { type ComponentChildren, createRef } from "preact";
import { IconButton } from "../controls/Button";
import * as messages from "../messages";
import css from "./ends.module.css";

/** The buttons that ask for another shape, where the focus goes once one is chosen. */
export const CARDS = { a: createRef<HTMLButtonElement>(), b: createRef<HTMLButtonElement>() };

interface EndCardProps {
  end: "a" | "b";
  name: string;
  /** More of it, for those who hear it, and in a word or two for the card. */
  note: string;
  count: string;
  picture: ComponentChildren;
  editing?: boolean;
  onChoose: () => void;
  /** Buttons at its foot. */
  children?: ComponentChildren;
}

/** A shape at one end of a morph. Pressed, it asks for another. */
export function EndCard(props: EndCardProps) {
  const { end, name, note, count, picture, editing = false, onChoose, children } = props;
  const letter = end.toUpperCase();
  return (
    <div class={`${css["card"]} ${editing ? css["editing"] : ""}`}>
      <button
        type="button"
        class={css["card-face"]}
        ref={CARDS[end]}
        aria-haspopup="dialog"
        aria-label={messages.shapeChoose(letter, name, note)}
        title={messages.chooseAnotherShape}
        onClick={onChoose}
      >
        {picture}
        <span class={css["card-end"]} aria-hidden="true">
          {letter}
        </span>
        <span class={css["card-name"]} translate={false}>
          {name}
        </span>
      </button>
      <div class={css["card-tools"]}>
        <span class={css["card-count"]} aria-hidden="true">
          {count}
        </span>
        {children}
      </div>
    </div>
  );
}

/** Between the two ends: each becomes the other. */
export function SwapEnds({ onSwap, disabled = false }: { onSwap: () => void; disabled?: boolean }) {
  return (
    <IconButton
      icon="swap"
      label={messages.swapAndB}
      kind="quiet"
      class={css["ends-swap"]}
      disabled={disabled}
      onClick={onSwap}
    />
  );
}
