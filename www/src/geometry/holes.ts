/** What is to be seen of a picture of few pixels: in how many parts it is, and how many holes it has. */

export interface Looks {
  /** Parts that hang together, pixels that meet in a corner, too. */
  parts: number;
  /** Parts of the ground that the picture encloses. */
  holes: number;
}

/** Pixels of a hole that is more than a flaw of its edge. */
const LEAST = 4;

/** `lit`: for each pixel, row by row, whether the shape is there. */
export function looksOf(lit: ArrayLike<boolean>, width: number, height: number): Looks {
  const seen = new Uint8Array(width * height);
  let [parts, holes] = [0, 0];
  const stack: number[] = [];
  for (let start = 0; start < seen.length; start++) {
    if (seen[start]) continue;
    const shape = lit[start] === true;
    let [size, edge] = [0, false];
    seen[start] = 1;
    stack.push(start);
    for (let at = stack.pop(); at !== undefined; at = stack.pop()) {
      size++;
      const x = at % width;
      const y = (at - x) / width;
      edge ||= x === 0 || y === 0 || x === width - 1 || y === height - 1;
      for (let dy = -1; dy <= 1; dy++) {
        for (let dx = -1; dx <= 1; dx++) {
          // The ground does not slip through where two pixels of the shape meet in a corner.
          if (!shape && dx !== 0 && dy !== 0) continue;
          const [p, q] = [x + dx, y + dy];
          if (p < 0 || q < 0 || p >= width || q >= height) continue;
          const next = q * width + p;
          if (seen[next] || (lit[next] === true) !== shape) continue;
          seen[next] = 1;
          stack.push(next);
        }
      }
    }
    if (shape) parts++;
    else if (!edge && size >= LEAST) holes++;
  }
  return { parts, holes };
}
