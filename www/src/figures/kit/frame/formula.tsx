import type { ComponentChildren } from "preact";
import { copyTex } from "../notation/copy";
import css from "../notation/formula.module.css";
import { letter, type Notation, type Tex } from "../notation/tex";

interface FormulaProps {
  tex: Tex;
  /** With a button that copies it: for those that are more than a symbol. All are copied with the words around. */
  copy?: boolean;
}

/** Mathematics, set apart from the words around it: as tex`...`, or the one letter that it is. */
export function Formula(props: FormulaProps | { children: ComponentChildren }) {
  if ("children" in props) return <Named of={props.children} />;
  const { tex: formula, copy = false } = props;
  const shown = (
    <span
      class={css["formula"]}
      translate={false}
      data-tex={formula.tex}
      dangerouslySetInnerHTML={{ __html: formula.html }}
    />
  );
  if (!copy) return shown;
  return (
    <span class={css["copied"]}>
      <span class={css["scroll"]}>{shown}</span>
      <button
        type="button"
        class={css["copy"]}
        aria-label="Copy as LaTeX"
        onClick={() => copyTex(formula.tex)}
      >
        TeX
      </button>
    </span>
  );
}

/** A symbol in one of both ways. */
export function Given({ as: given }: { as: Notation }) {
  return typeof given === "string" ? <Named of={given} /> : <Formula tex={given} />;
}

/** A letter as mathematics; more than that is a name. */
function Named({ of: name }: { of: ComponentChildren }) {
  const tex = typeof name === "string" ? letter(name) : null;
  return tex ? <Formula tex={tex} /> : <span class={css["named"]}>{name}</span>;
}
