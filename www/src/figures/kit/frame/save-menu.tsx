import { useRef } from "preact/hooks";
import { notify, wordsOf } from "#document/notice";
import { Menu } from "#ui/overlay/Menu";
import css from "./frame.module.css";
import type { Named, Saved } from "./save";

/** The way of a figure into a file. What writes it is fetched when it is asked for. */
export function SaveMenu({ number, title }: Named) {
  const host = useRef<HTMLDivElement>(null);
  const save = async (what: Saved) => {
    const page = host.current?.closest("article");
    if (!page) return;
    try {
      const { saveFigure } = await import("./save");
      await saveFigure(page, { number, title }, what);
    } catch (problem) {
      notify({ kind: "error", text: `The picture could not be saved: ${wordsOf(problem)}` });
    }
  };
  const item = (label: string, kind: Saved["kind"], ground: Saved["ground"]) => ({
    label,
    onSelect: () => void save({ kind, ground }),
  });
  return (
    <div class={css["figure-save"]} ref={host}>
      <Menu
        label="Save the picture"
        icon="save"
        items={[
          item("Save as PNG", "png", "white"),
          item("Save as SVG", "svg", "white"),
          item("Save as PNG, background clear", "png", "clear"),
          item("Save as SVG, background clear", "svg", "clear"),
        ]}
      />
    </div>
  );
}
