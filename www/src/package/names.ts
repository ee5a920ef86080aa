/** What can be asked of the package's pool: where each function is, and how many arguments it takes. */
export const NAMES = {
  attractor: ["draw", 2],
  rasterize: ["draw", 2],
  barnsleyTest: ["proof", 2],
  candidates: ["proof", 3],
  certificate: ["proof", 2],
  certifyPath: ["proof", 4],
  checkCertificate: ["proof", 1],
  checkPath: ["proof", 4],
  connectedness: ["proof", 2],
  indexBuffer: ["proof", 2],
  locus: ["proof", 3],
  planPath: ["proof", 3],
  rateCandidate: ["proof", 3],
  routes: ["proof", 2],
  fitCurve: ["fit", 2],
  houghMaps: ["fit", 3],
  rivalFit: ["fit", 3],
  traceOutline: ["fit", 4],
  attractor3: ["space", 2],
  boxes3: ["space", 1],
  checkPath3: ["space", 4],
  connectedness3: ["space", 2],
  facts3: ["space", 1],
  findPath3: ["space", 3],
} as const;

export type Name = keyof typeof NAMES;
