import "#ui/panel/progress.css";
import { useEffect, useRef } from "preact/hooks";
import { Button, IconButton } from "#ui/controls/Button";
import css from "./film.module.css";
import { besideIt, isBackAtChip, leaveChip } from "./focus";
import { cancel, job, made } from "./job";
import * as messages from "./messages";
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
      <section class={css["film-chip"]} aria-label={messages.filmInProgress} title={name}>
        <Button
          kind="quiet"
          icon="play"
          description={messages.watchFilmWhileRenders}
          buttonRef={opener}
          onClick={open}
        >
          <span class={css["film-chip-words"]}>
            {messages.film} <span class="number">{Math.floor((100 * done) / Math.max(1, of))}%</span>
          </span>
        </Button>
        <progress
          class="progress"
          max={of}
          value={done}
          aria-label={messages.framesRendered}
          title={left === null ? "" : messages.leftIs(timeWords(left))}
        />
        <IconButton icon="close" kind="quiet" label={messages.cancelFilm} onClick={gone(cancel)} />
      </section>
    );
  }
  if (!made.value || !filmUnseen.value) return null;
  return (
    <section class={css["film-chip"]} aria-label={messages.film2} title={made.value.name}>
      <span class={css["film-chip-words"]} role="status">
        {messages.filmInYourDownloads}
      </span>
      <Button kind="quiet" class={css["film-chip-open"]} buttonRef={opener} onClick={open}>
        {messages.open}
      </Button>
      <IconButton
        icon="close"
        kind="quiet"
        label={messages.dismiss}
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
