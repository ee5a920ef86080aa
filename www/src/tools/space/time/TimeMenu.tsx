import { changeTimeline } from "#document/space/edits";
import { timeline } from "#document/space/space";
import { openFilm } from "#film/open";
import { Menu } from "#ui/overlay/Menu";
import { fly } from "./flight/fly";
import { attempt, removeAllKeys, stretch } from "./keys/keys";
import * as messages from "./messages";
import { openAnimation } from "./saved/open";
import css from "./time.module.css";

/** What else can be done with time. `all` also has what stands beside it where there is room. */
export function TimeMenu({ all = false }: { all?: boolean }) {
  const line = timeline.value;
  const course = (to: "smooth" | "straight", label: string) => ({
    label,
    disabled: !line,
    ...(line?.course === to ? { icon: "check" as const } : {}),
    onSelect: () =>
      attempt(() => changeTimeline((now) => (now.course === to ? now : { ...now, course: to }))),
  });
  return (
    <div class={css["time-menu"]}>
      <Menu
        label={messages.moreOptionsForTime}
        items={[
          { label: messages.flyThrough, onSelect: () => fly("through") },
          { label: messages.flyAround, onSelect: () => fly("around") },
          course("smooth", messages.smoothAtKeyframes),
          course("straight", messages.straightBetweenKeyframes),
          { label: messages.halfSpeed, disabled: !line, onSelect: () => stretch(1.5) },
          { label: messages.doubleSpeed, disabled: !line, onSelect: () => stretch(0.5) },
          { label: messages.openSavedAnimation, onSelect: openAnimation },
          ...(all ? [{ label: messages.exportLabel, icon: "save" as const, onSelect: openFilm }] : []),
          { label: messages.removeAllKeyframes, icon: "bin", disabled: !line, onSelect: removeAllKeys },
        ]}
      />
    </div>
  );
}
