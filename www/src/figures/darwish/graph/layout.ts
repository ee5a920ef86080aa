/** Where the states of a graph are drawn. */

/** All that leads from one state to another. */
export interface StateWay {
  from: number;
  to: number;
  /** What stands at the arrow. */
  label: string;
}

/** States that are drawn; more of them would be a thicket. */
export const MOST_DRAWN = 16;

/** Where a state is drawn when there are many: the first at the left, the others on a ring. */
export function ringPlace(index: number, count: number, radius: number): [x: number, y: number] {
  const angle = Math.PI + (2 * Math.PI * index) / Math.max(1, count);
  return [radius * Math.cos(angle), radius * Math.sin(angle)];
}

/** The same when there are few: from the first to the right, a column for each step of the way. */
export function columnsOf(count: number, ways: readonly Pick<StateWay, "from" | "to">[]): number[][] {
  const columns: number[][] = [];
  const known = new Set<number>();
  for (let now = count > 0 ? [0] : []; now.length > 0; ) {
    for (const index of now) known.add(index);
    columns.push(now);
    const next = new Set(ways.filter(({ from }) => now.includes(from)).map(({ to }) => to));
    now = [...next].filter((index) => index < count && !known.has(index)).sort((a, b) => a - b);
  }
  return columns;
}
