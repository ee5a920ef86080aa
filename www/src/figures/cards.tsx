import type { ComponentChildren, ComponentType } from "preact";
import { lazily } from "#ui/lazy";
import css from "./cards.module.css";
import type { Figure } from "./figure";
import frameCss from "./kit/frame/frame.module.css";
import { hrefOf } from "./list";
import { thumbOf } from "./loading";

/** Small pictures are fetched when they are first shown. */
const thumbs = new Map<string, ComponentType>();

function thumb(figure: Figure): ComponentType {
  const found = thumbs.get(figure.id) ?? lazily(() => thumbOf(figure));
  thumbs.set(figure.id, found);
  return found;
}

/** The small picture of a figure or a lesson. */
export function Thumbnail({ of }: { of: Figure }) {
  const Thumb = thumb(of);
  return (
    <span class={css["figure-thumb"]} aria-hidden="true">
      <Thumb />
    </span>
  );
}

interface CardsProps<F extends Figure> {
  figures: readonly F[];
  /** What else is to be said of one. */
  also?: (figure: F) => ComponentChildren;
}

/** Ways to figures or lessons, each with a small picture. */
export function Cards<F extends Figure>({ figures, also }: CardsProps<F>) {
  return (
    <ul class={css["cards"]}>
      {figures.map((figure) => {
        return (
          <li key={figure.id}>
            <a class={css["figure-card"]} href={hrefOf(figure)}>
              <Thumbnail of={figure} />
              <span class={frameCss["figure-number"]}>{figure.number}</span>
              <strong>{figure.title}</strong>
              <span class={css["about"]}>{figure.about}</span>
              {also?.(figure)}
            </a>
          </li>
        );
      })}
    </ul>
  );
}
