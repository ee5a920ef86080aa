/** What went wrong, in words; nothing where nothing did. */
export function Problem({ words }: { words: string | null }) {
  return (
    words !== null && (
      <p class="problem" role="alert">
        {words}
      </p>
    )
  );
}
