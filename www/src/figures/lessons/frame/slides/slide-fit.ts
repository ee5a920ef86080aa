/** A slide as large as it fits the window; what is larger still is scrolled, and it is said that it goes on. */
import type { RefObject } from "preact";
import { useEffect, useLayoutEffect, useState } from "preact/hooks";

/**
 * How small a slide becomes to fit, its words as a part of their size, its pictures as a part of the width: pictures
 * give way first, since the last row must still read the words.
 */
const SIZES = [
  [1, 1],
  [1, 0.92],
  [1, 0.84],
  [0.92, 0.84],
  [0.92, 0.76],
  [0.84, 0.76],
  [0.84, 0.68],
  [0.76, 0.64],
  [0.7, 0.6],
  [0.7, 0.5],
] as const;
/** What fits at no size is scrolled, and as large as it is read well. */
const SCROLLED = [0.92, 0.84] as const;
/** Less than this is no more to be seen, in pixels. */
const LITTLE = 12;

const scroller = (from: Element | null) => from?.closest("main") ?? null;
const hidden = (main: Element) => main.scrollHeight - main.clientHeight;

/**
 * Makes the slide that is shown as large as it fits: for each slide anew, and when the window changes. What grows while
 * it is shown, as by an answer, makes it smaller, and nothing makes it larger again: it would jump to and fro.
 */
export function useFit(bar: RefObject<Element | null>, at: number, count: number): void {
  // biome-ignore lint/correctness/useExhaustiveDependencies: each slide has a size of its own
  useLayoutEffect(() => {
    const root = document.documentElement;
    let tried = 0;
    const set = ([words, pictures]: readonly [number, number]) => {
      root.style.setProperty("--slide-size", String(words));
      root.style.setProperty("--slide-picture", String(pictures));
    };
    const shrink = () => {
      const main = scroller(bar.current);
      if (!main) return;
      if (tried >= SIZES.length) return;
      for (; tried < SIZES.length; tried++) {
        set(SIZES[tried] ?? SCROLLED);
        if (hidden(main) <= 0) return;
      }
      set(SCROLLED);
    };
    const adjust = () => {
      tried = 0;
      shrink();
    };
    adjust();
    // Charts have their size a moment later.
    const frame = requestAnimationFrame(adjust);
    addEventListener("resize", adjust);
    const grown = new ResizeObserver(shrink);
    const article = bar.current?.closest("article");
    if (article) grown.observe(article);
    return () => {
      cancelAnimationFrame(frame);
      grown.disconnect();
      removeEventListener("resize", adjust);
      root.style.removeProperty("--slide-size");
      root.style.removeProperty("--slide-picture");
    };
  }, [bar, at, count]);
}

/** Whether the slide goes on below what is seen, and the way there. */
export function useBelow(bar: RefObject<Element | null>, at: number): [isMore: boolean, onward: () => void] {
  const [isMore, setMore] = useState(false);
  // biome-ignore lint/correctness/useExhaustiveDependencies: another slide begins at its top
  useEffect(() => {
    const main = scroller(bar.current);
    const article = bar.current?.closest("article");
    if (!main || !article) return;
    const look = () => setMore(hidden(main) - main.scrollTop > LITTLE);
    const grown = new ResizeObserver(look);
    grown.observe(article);
    main.addEventListener("scroll", look, { passive: true });
    look();
    return () => {
      grown.disconnect();
      main.removeEventListener("scroll", look);
    };
  }, [bar, at]);
  const onward = () => {
    const main = scroller(bar.current);
    main?.scrollBy({ top: 0.7 * main.clientHeight });
  };
  return [isMore, onward];
}
