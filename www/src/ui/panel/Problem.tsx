import { useEffect, useRef } from "preact/hooks";

/** What went wrong, in words, which come into sight; nothing where nothing did. */
export function Problem({ words }: { words: string | null }) {
  const problem = useRef<HTMLParagraphElement>(null);
  useEffect(() => {
    if (words !== null) problem.current?.scrollIntoView({ block: "nearest" });
  }, [words]);
  return (
    words !== null && (
      <p class="problem" role="alert" ref={problem}>
        {words}
      </p>
    )
  );
}
