/**
 * Does pieces of work of which several are under way at a time, and takes their results in their order. `ahead` is how
 * many may be under way or done and not taken yet.
 */
export async function inOrder<T>(
  count: number,
  ahead: number,
  begin: (index: number) => Promise<T>,
  take: (index: number, result: T) => Promise<void>,
): Promise<void> {
  const queue: Promise<T>[] = [];
  let next = 0;
  for (let i = 0; i < count; i++) {
    while (next < count && queue.length < ahead) {
      const work = begin(next++);
      // Whoever waits for it hears of it when its turn comes.
      work.catch(() => {});
      queue.push(work);
    }
    const first = queue.shift();
    if (first) await take(i, await first);
  }
}
