import "./subject-card.css";
import type { ComponentChildren } from "preact";
import * as messages from "../messages";

interface SubjectCardProps {
  /** A small picture of it. */
  picture: ComponentChildren;
  name: ComponentChildren;
  about: ComponentChildren;
  /** Opens a choice of others, which `label` says. */
  onChoose?: () => void;
  label?: string;
}

/** What is worked on: its picture, its name and a line about it. */
export function SubjectCard({ picture, name, about, onChoose, label }: SubjectCardProps) {
  const inside = (
    <>
      {picture}
      <span class="subject-name">{name}</span>
      <span class="subject-about">{about}</span>
    </>
  );
  if (!onChoose) return <div class="subject">{inside}</div>;
  return (
    <button
      type="button"
      class="subject"
      aria-haspopup="dialog"
      aria-label={label}
      title={messages.chooseAnotherShape}
      onClick={onChoose}
    >
      {inside}
    </button>
  );
}
