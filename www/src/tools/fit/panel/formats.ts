import * as messages from "./messages";

/** What can be chosen, dropped or pasted: for the file dialog, and in words. */
export const ACCEPT =
  "image/png,image/jpeg,image/webp,image/avif,image/gif,image/bmp,image/svg+xml,.svg,.csv,.tsv,.txt,.tps,.json,.geojson,.topojson,text/csv,application/json,application/geo+json";

export const READS = messages.reads;
