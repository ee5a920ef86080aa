import { useEffect, useRef, useState } from "preact/hooks";

/** Calls `step` at every frame while it plays, with the seconds since the last; stops when that returns false. */
export function usePlay(step: (seconds: number) => boolean): {
  playing: boolean;
  toggle: () => void;
  stop: () => void;
} {
  const [playing, setPlaying] = useState(false);
  const latest = useRef(step);
  latest.current = step;
  useEffect(() => {
    if (!playing) return;
    let last: number | null = null;
    let frame = requestAnimationFrame(function tick(now) {
      // A frame that comes late moves a tenth of a second at most.
      const seconds = last === null ? 0 : Math.min(0.1, (now - last) / 1000);
      last = now;
      if (!latest.current(seconds)) setPlaying(false);
      else frame = requestAnimationFrame(tick);
    });
    const hidden = () => document.hidden && setPlaying(false);
    document.addEventListener("visibilitychange", hidden);
    return () => {
      cancelAnimationFrame(frame);
      document.removeEventListener("visibilitychange", hidden);
    };
  }, [playing]);
  return { playing, toggle: () => setPlaying(!playing), stop: () => setPlaying(false) };
}
