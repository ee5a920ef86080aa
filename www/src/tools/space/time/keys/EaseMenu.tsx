import { changeTimeline } from "#document/space/edits";
import { Menu } from "#ui/overlay/Menu";
import type { SpaceKey } from "#wasm/api";
import { withEase } from "../changes";
import * as messages from "../messages";
import { EASES, easeWords } from "../words";
import { attempt } from "./keys";

/** How it goes on from a key to the next one. */
export function EaseMenu({ of, index }: { of: SpaceKey; index: number }) {
  return (
    <div title={messages.easeFrom(index + 1, easeWords(of.ease))}>
      <Menu
        label={messages.easeAfter(index + 1, easeWords(of.ease))}
        icon="arrow"
        items={EASES.map(({ value, label }) => ({
          label,
          ...(value === of.ease ? { icon: "check" as const } : {}),
          onSelect: () => attempt(() => changeTimeline((line) => withEase(line, index, value))),
        }))}
      />
    </div>
  );
}
