import type { ComponentChildren } from "preact";
import { Icon } from "#ui/controls/Icon";
import type { Notation, Tex } from "../notation/tex";
import { CopyLink } from "../state/copy-link";
import { Formula, Given } from "./formula";
import css from "./frame.module.css";
import { SaveMenu } from "./save-menu";

export interface Heading {
  /** The last part of its address. */
  id: string;
  number: string;
  title: string;
}

export interface Parameter {
  name: string;
  symbol?: Notation;
  /** As words, or as formulas. */
  value: string | readonly (Tex | string)[];
}

interface FrameProps extends Heading {
  /** What it teaches, in a sentence or two. */
  lead: ComponentChildren;
  /** The part that moves. */
  children: ComponentChildren;
  /** What Frond finds, where that says more than the paper, or other. */
  found?: ComponentChildren;
  parameters: readonly Parameter[];
  /** The captions of the paper. */
  captions: readonly string[];
  /** Why the picture is not the paper's own: what was not printed, and what stands for it here; null where all was. */
  reconstructed: string | null;
  /**
   * The picture is Frond’s own, on the paper's subject: hardly anything of it was printed. `reconstructed` says what.
   */
  own?: boolean;
  /** What differs from the paper all the same. */
  differs?: ComponentChildren;
  studio?: { href: string; label?: string };
}

/** What every figure has around its live part. */
export function Frame(props: FrameProps) {
  return (
    <>
      <Head
        number={props.number}
        title={props.title}
        badge={props.own ? "Frond’s own" : props.reconstructed === null ? "as printed" : "reconstructed"}
        {...(props.studio ? { studio: props.studio } : {})}
      >
        {props.lead}
      </Head>
      <section class={css["figure-live"]} data-testid="live" aria-label="The figure">
        {props.children}
      </section>
      <div class={css["figure-foot"]}>
        {props.found !== undefined && (
          <section class={css["figure-found"]} aria-labelledby="figure-found">
            <h2 id="figure-found">What Frond finds</h2>
            {props.found}
          </section>
        )}
        <section aria-labelledby="figure-parameters">
          <h2 id="figure-parameters">Parameters</h2>
          <Parameters of={props.parameters} />
        </section>
        <section aria-labelledby="figure-paper">
          <h2 id="figure-paper">In the paper</h2>
          {props.captions.map((caption) => (
            <blockquote key={caption}>{caption}</blockquote>
          ))}
          {props.reconstructed !== null && (
            <p>
              <strong>{props.own ? "Frond’s own." : "Reconstructed."}</strong> {props.reconstructed}
            </p>
          )}
          {props.differs !== undefined && (
            <p>
              <strong>What differs.</strong> {props.differs}
            </p>
          )}
        </section>
      </div>
    </>
  );
}

interface HeadProps extends Omit<Heading, "id"> {
  /** Where the page comes from, in a word or two. */
  badge: string;
  studio?: { href: string; label?: string };
  /** The text that leads in. */
  children: ComponentChildren;
  /** What else can be done with the page. */
  more?: ComponentChildren;
}

/** The name of a page, its way into the studio, and its text. */
export function Head({ number, title, badge, studio, children, more }: HeadProps) {
  return (
    <header class={css["figure-head"]} data-step="text">
      <div>
        <p class={css["figure-number"]}>
          {number}{" "}
          <span class={css["badge"]} data-testid="badge">
            {badge}
          </span>
        </p>
        <h1 tabIndex={-1}>{title}</h1>
      </div>
      <div class={css["figure-ways"]}>
        {studio && (
          <a class={`button ${css["figure-studio"]}`} data-testid="studio-link" href={studio.href}>
            {studio.label ?? "Open in the studio"}
            <Icon name="arrow" />
          </a>
        )}
        <div class={css["figure-icons"]}>
          {more}
          <CopyLink />
          <SaveMenu number={number} title={title} />
        </div>
      </div>
      <div class={css["figure-lead"]}>{children}</div>
    </header>
  );
}

/** Formulas alone can be copied one by one; with words between them they are read as one. */
function Value({ of: value }: { of: Parameter["value"] }) {
  if (typeof value === "string") return <>{value}</>;
  const alone = value.every((part) => typeof part !== "string");
  return (
    <>
      {value.map((part, i) =>
        typeof part === "string" ? part : <Formula key={`${i}`} tex={part} copy={alone} />,
      )}
    </>
  );
}

export function Parameters({ of }: { of: readonly Parameter[] }) {
  return (
    <dl class={css["parameters"]}>
      {of.map(({ name, symbol, value }) => (
        <div key={name}>
          <dt>
            {name} {symbol !== undefined && <Given as={symbol} />}
          </dt>
          <dd class="number">
            <Value of={value} />
          </dd>
        </div>
      ))}
    </dl>
  );
}
