import type { ComponentChildren } from "preact";
import * as messages from "../messages";
import { NameInput } from "../shapes/NameInput";
import css from "./kept-row.module.css";

interface KeptRowProps {
  name: string;
  /** A small picture of it, or two. */
  picture: ComponentChildren;
  about: ComponentChildren;
  /** Not where it cannot be read. */
  onOpen?: (() => void) | undefined;
  /** Whether its name is typed just now. */
  naming: boolean;
  longest: number;
  onName: (name: string) => void;
  onNamed: () => void;
  /** One small picture and a line of tools, in the width of a panel. */
  small?: boolean;
  /** What else can be done with it. */
  children: ComponentChildren;
}

/** Something that is kept in this browser: its picture, which opens it, its name, and what can be done with it. */
export function KeptRow(props: KeptRowProps) {
  const { name, picture, about, onOpen, naming, longest, onName, onNamed, small = false, children } = props;
  const called = name || messages.untitled;
  return (
    <li class={`${css["row"]} ${small ? css["small"] : ""}`}>
      <button
        type="button"
        class={css["open"]}
        disabled={onOpen === undefined}
        aria-label={messages.openNamed(called)}
        onClick={onOpen}
      >
        {picture}
      </button>
      <div class={css["words"]}>
        {naming ? (
          <NameInput
            label={messages.nameOf(called)}
            name={name}
            longest={longest}
            focused
            onName={onName}
            onEnd={onNamed}
          />
        ) : (
          <b>{called}</b>
        )}
        <span class="hint">{about}</span>
      </div>
      <div class={css["tools"]}>{children}</div>
    </li>
  );
}

/** Rows of what is kept. */
export function KeptRows({ children }: { children: ComponentChildren }) {
  return <ul class={css["rows"]}>{children}</ul>;
}
