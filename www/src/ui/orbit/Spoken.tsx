import { useEffect, useRef, useState } from "preact/hooks";

/** While much happens by itself, so much of it is said aloud. */
const EVERY_MS = 4000;

/** Words for those who hear the page: at once, or, while something plays, no more than can be listened to. */
export function Spoken({ words, playing }: { words: string; playing: boolean }) {
  const [said, setSaid] = useState(words);
  const latest = useRef(words);
  latest.current = words;
  useEffect(() => {
    if (!playing) return setSaid(words);
  }, [words, playing]);
  useEffect(() => {
    if (!playing) return;
    const timer = setInterval(() => setSaid(latest.current), EVERY_MS);
    return () => clearInterval(timer);
  }, [playing]);
  return (
    <p class="unseen" aria-live="polite" data-testid="orbit-spoken">
      {said}
    </p>
  );
}
