import "#ui/panel/progress.css";
import { useEffect, useRef } from "preact/hooks";
import { Button, IconButton } from "#ui/controls/Button";
import css from "./film.module.css";
import { besideIt, isBackAtChip, leaveChip } from "./focus";
import { cancel, job, made } from "./job";
import { filmUnseen, openFilm } from "./open";
import { timeWords } from "./plan";

/** The film in the making, or the one that is made, while its dialog is closed. */
export function FilmChip() {
  const opener = useRef<HTMLButtonElement>(null);
  useEffect(() => {
    if (isBackAtChip()) opener.current?.focus({ preventScroll: true });
  }, []);
  const now = job.value;
  if (now) {
    const { done, of, left, name } = now;
    return (
      <section class={css["film-chip"]} aria-label="The film in the making" title={name}>
        <Button
          kind="quiet"
          icon="play"
          description="Watch the film being made"
          buttonRef={opener}
          onClick={open}
        >
          <span class={css["film-chip-words"]}>
            Film <span class="number">{Math.floor((100 * done) / Math.max(1, of))}%</span>
          </span>
        </Button>
        <progress
          class="progress"
          max={of}
          value={done}
          aria-label="Frames made"
          title={left === null ? "" : `About ${timeWords(left)} left`}
        />
        <IconButton icon="close" kind="quiet" label="Cancel the film" onClick={gone(cancel)} />
      </section>
    );
  }
  if (!made.value || !filmUnseen.value) return null;
  return (
    <section class={css["film-chip"]} aria-label="The film" title={made.value.name}>
      <span class={css["film-chip-words"]} role="status">
        The film is in your downloads.
      </span>
      <Button kind="quiet" class={css["film-chip-open"]} buttonRef={opener} onClick={open}>
        Open
      </Button>
      <IconButton
        icon="close"
        kind="quiet"
        label="Dismiss"
        onClick={gone(() => {
          filmUnseen.value = false;
        })}
      />
    </section>
  );
}

function open(): void {
  leaveChip();
  openFilm();
}

/** The chip goes, and with it the button: by a key, the focus goes to what is beside it. */
const gone = (act: () => void) => (event: MouseEvent) => {
  act();
  if (event.detail === 0) besideIt()?.focus();
};
