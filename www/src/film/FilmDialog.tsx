import { useEffect, useLayoutEffect, useState } from "preact/hooks";
import { wordsOf } from "#document/notice";
import { Button } from "#ui/controls/Button";
import { Dialog } from "#ui/overlay/Dialog";
import { Finished } from "./Finished";
import css from "./film.module.css";
import { besideChip, headingIfLost } from "./focus";
import { job, made } from "./job";
import * as messages from "./messages";
import { exportOpen } from "./open";
import { isFilm } from "./plan";
import { Running } from "./Running";
import { Settings } from "./Settings";
import { offer, plan, subject } from "./settings";
import type { Films } from "./subject";

const close = () => {
  exportOpen.value = null;
};

/**
 * A film of what moves, or its numbers: choose, watch it being made, and have it. `films` is what the open tool has to
 * film; a film of another tool is shown without.
 */
export function FilmDialog({ films }: { films: (() => Promise<Films>) | undefined }) {
  return (
    <Dialog title={messages.exportLabel} about={about()} onClose={close} back={besideChip} wide>
      {job.value ? (
        <Running job={job.value} />
      ) : made.value ? (
        <Finished made={made.value} />
      ) : films ? (
        <Choose films={films} />
      ) : (
        <Without />
      )}
    </Dialog>
  );
}

function Without() {
  useLayoutEffect(headingIfLost, []);
  return <p class={css["export-nothing"]}>{messages.nothingHereCanFilmed}</p>;
}

function about(): string {
  if (job.value) return messages.youCanCloseThis;
  if (made.value) return messages.inYourDownloads;
  return isFilm(plan.value.kind) ? messages.everyFrameCompleteHowever : messages.numbersInsteadPixelsEach;
}

function Choose({ films }: { films: () => Promise<Films> }) {
  const [found, setFound] = useState<Films | { problem: string } | null>(null);
  useEffect(() => {
    films().then(
      (now) => {
        offer(now.subjects);
        setFound(now);
      },
      (problem) => setFound({ problem: wordsOf(problem) }),
    );
  }, [films]);
  useLayoutEffect(() => {
    if (found) headingIfLost();
  }, [found]);
  if (!found) return <p class={css["export-nothing"]}>{messages.preparing}</p>;
  if ("problem" in found) return <p class={css["export-problem"]}>{found.problem}</p>;
  if (subject.value) return <Settings of={subject.value} />;
  const { nothing } = found;
  if (!nothing) return null;
  return (
    <div class={css["export-nothing"]}>
      <p>{nothing.words}</p>
      <Button
        kind="primary"
        disabled={nothing.disabled}
        onClick={() => {
          close();
          nothing.run();
        }}
      >
        {nothing.label}
      </Button>
    </div>
  );
}
