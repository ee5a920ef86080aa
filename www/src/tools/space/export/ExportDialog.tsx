import { space, timeline } from "#document/space/space";
import { Button } from "#ui/controls/Button";
import { Dialog } from "#ui/overlay/Dialog";
import { exportOpen } from "../time/exporting";
import { fly } from "../time/flight/fly";
import css from "./export.module.css";
import { Finished } from "./Finished";
import { job, made } from "./job";
import { isFilm } from "./plan";
import { Running } from "./Running";
import { Settings } from "./Settings";
import { plan } from "./settings";

const close = () => {
  exportOpen.value = false;
};

/** A film of the time line, or its numbers: choose, watch it being made, and have it. */
export function ExportDialog() {
  return (
    <Dialog title="Export" about={about()} onClose={close} wide>
      {job.value ? <Running job={job.value} /> : made.value ? <Finished made={made.value} /> : <Choose />}
    </Dialog>
  );
}

function about(): string {
  if (job.value) return "You can close this, and go on working: it is made all the same.";
  if (made.value) return "It is in your downloads.";
  return isFilm(plan.value.kind)
    ? "Every frame is complete: carved, not dotted, however long that takes."
    : "Numbers, not pixels: each frame is a set of parameters.";
}

function Choose() {
  if (space.value && timeline.value) return <Settings />;
  return (
    <div class={css["export-nothing"]}>
      <p>Nothing moves yet, so there is nothing to film. Set two keys, or begin with a ready flight.</p>
      <Button
        kind="primary"
        disabled={!space.value}
        onClick={() => {
          close();
          fly("through");
        }}
      >
        Fly through
      </Button>
    </div>
  );
}
