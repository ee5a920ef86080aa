/** A verdict for those who do not see its chip. */
import { computed } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { announce } from "#document/notice";

interface Told {
  /** What is known; nothing while nothing is. */
  text: string;
  /** Whether the picture moves, or this is still about the moment before. */
  moving: boolean;
}

const REST_MS = 900;

/** What was last said, or seen first: where a chip takes the place of another, what it says is news, too. */
let said = "";

/** From now on says what is known aloud, once it has come to rest and where it has changed; gives the end of it. */
export function sayAtRest(told: () => Told): () => void {
  let timer: ReturnType<typeof setTimeout> | null = null;
  const stop = computed(told).subscribe(({ text, moving }) => {
    if (timer) clearTimeout(timer);
    if (moving || text === said || !text) return;
    timer = setTimeout(() => {
      // The first is on screen with the page; only what changes is news.
      if (said) announce(text);
      said = text;
    }, REST_MS);
  });
  return () => {
    if (timer) clearTimeout(timer);
    stop();
  };
}

/** The same for as long as the chip is there. */
export function useSaidAtRest(told: () => Told): void {
  // biome-ignore lint/correctness/useExhaustiveDependencies: what it reads are signals, which tell by themselves
  useEffect(() => sayAtRest(told), []);
}
