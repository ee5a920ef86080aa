/** Functions that Cochran, Hart & Flynn print. A map is [a, b, c, d, e]: t' = a t + d, x' = b t + c x + e (eq 1). */
import type { Graph } from "#wasm/api";

/** Table 1, on [-1, 1]. */
export const TABLE_1: Graph = {
  kind: "fif",
  pieces: [
    { map: [0.5, 0.746, 0.5, -0.5, 0.246], domain: [-1, 1] },
    { map: [0.5, -0.199, -0.6, 0.5, 0.189], domain: [-1, 1] },
  ],
};

/** Table 3 in the fractions that it rounds: what the authors picked by hand for the hidden-variable function. */
export const TABLE_3: Graph = {
  kind: "pfif",
  pieces: [
    { map: [-1 / 3, 0, -1 / 2, 2 / 9, 3 / 8], domain: [5 / 18, 2 / 3] },
    { map: [1 / 3, 0, -1 / 2, 2 / 27, 9 / 16], domain: [1 / 6, 1 / 2] },
    { map: [1 / 3, 0, 1 / 2, 5 / 27, 1 / 16], domain: [1 / 6, 4 / 9] },
    { map: [1 / 3, 0, 1 / 2, 1 / 3, 1 / 4], domain: [0, 1] },
    { map: [-1 / 3, 0, -1 / 2, 22 / 27, 15 / 16], domain: [1 / 6, 4 / 9] },
    { map: [-1 / 3, 0, 1 / 2, 25 / 27, 7 / 16], domain: [1 / 6, 1 / 2] },
    { map: [1 / 3, 0, 1 / 2, 7 / 9, 5 / 8], domain: [5 / 18, 2 / 3] },
  ],
};
