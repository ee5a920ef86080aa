import { computed } from "@preact/signals";
import { thumbnails } from "#compute/results";
import { selection } from "#document/morph";
import { announce, notify } from "#document/notice";
import { edit, scene } from "#document/scene";
import { IconButton } from "#ui/controls/Button";
import { startExport } from "#ui/files/exporting";
import { Menu } from "#ui/overlay/Menu";
import { EndCard, SwapEnds } from "#ui/shapes/EndCard";
import endsCss from "#ui/shapes/ends.module.css";
import { Thumbnail } from "#ui/shapes/Thumbnail";
import { askForNew, editMaps, endEditing, gallery, PENCILS, takeWhole } from "../dialogs";
import { shapes } from "../document-signals";
import { asBoth, type End, nameOf, other, swap } from "../edits";
import { keepingPath } from "../locus/path/automatic";
import * as messages from "../messages";
import { changedWord } from "./matched";

/** The two ends of the morph, with the arrow that swaps them. */
export function Ends() {
  return (
    <section class={endsCss["ends"]} aria-label={messages.twoShapes}>
      <Card end="a" />
      <SwapEnds
        onSwap={() => {
          keepingPath(() => edit(swap));
          announce(messages.swapped(scene.peek().a.name, scene.peek().b.name));
        }}
      />
      <Card end="b" />
    </section>
  );
}

/** Not drawn again at every moment of a morph that plays. */
const wordOf = (end: End) =>
  computed(() => (scene.value[end].preset === undefined ? changedWord(scene.value[end], scene.value) : null));
const changed = { a: wordOf("a"), b: wordOf("b") };

function Card({ end }: { end: End }) {
  const { name, maps, preset } = shapes[end].value;
  const editing = selection.value?.target === end;
  const count = `${maps.length} ${maps.length === 1 ? "copy" : "copies"}`;
  const word = changed[end].value;
  return (
    <EndCard
      end={end}
      name={name}
      note={word ? `${count}, ${word}` : count}
      count={word ?? count}
      picture={<Thumbnail bitmap={thumbnails.value.get(end) ?? thumbnails.value.get(preset ?? "")} />}
      editing={editing}
      onChoose={() => {
        gallery.value = end;
      }}
    >
      <IconButton
        kind="quiet"
        icon="edit"
        label={messages.editMapsOf(nameOf(end))}
        pressed={editing}
        buttonRef={PENCILS[end]}
        onClick={() => (editing ? endEditing() : editMaps(end))}
      />
      <Menu
        label={messages.moreFor(nameOf(end))}
        items={[
          {
            label: messages.chooseAnother,
            icon: "grid",
            onSelect: () => {
              gallery.value = end;
            },
          },
          {
            label: messages.newShape,
            icon: "add",
            onSelect: () => askForNew(end),
          },
          {
            label: messages.moveRotateOrScale,
            icon: "edit",
            onSelect: () => takeWhole(end),
          },
          {
            label: messages.mapsAsText,
            icon: "file",
            onSelect: startExport,
          },
          {
            label: messages.saveThisShape,
            icon: "check",
            onSelect: async () => {
              const { keepShape } = await import("#document/own-shapes");
              const problem = keepShape(shapes[end].peek());
              notify({
                kind: "info",
                text: problem ?? messages.isKept(name),
              });
            },
          },
          {
            label: messages.alsoAs(nameOf(other(end))),
            icon: "copy",
            onSelect: () => {
              edit((before) => asBoth(before, end));
              announce(messages.atBothEnds(name));
            },
          },
        ]}
      />
    </EndCard>
  );
}
