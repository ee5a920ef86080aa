import { changeTimeline } from "#document/space/edits";
import { timeline } from "#document/space/space";
import { openFilm } from "#film/open";
import { Menu } from "#ui/overlay/Menu";
import { fly } from "./flight/fly";
import { attempt, removeAllKeys, stretch } from "./keys/keys";
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
        label="More of time"
        items={[
          { label: "Fly through", onSelect: () => fly("through") },
          { label: "Fly around", onSelect: () => fly("around") },
          course("smooth", "Smooth at the keys"),
          course("straight", "Straight from key to key"),
          { label: "All of it slower by half", disabled: !line, onSelect: () => stretch(1.5) },
          { label: "Twice as fast", disabled: !line, onSelect: () => stretch(0.5) },
          { label: "Open a saved animation …", onSelect: openAnimation },
          ...(all ? [{ label: "Export …", icon: "save" as const, onSelect: openFilm }] : []),
          { label: "Remove all keys", icon: "bin", disabled: !line, onSelect: removeAllKeys },
        ]}
      />
    </div>
  );
}
