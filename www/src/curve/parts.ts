/** What tools show of closed curves: loaded when there are some, or when one may be chosen. */
import { lazily } from "#ui/lazy";
import { loadCurves } from "#wasm/curve";

/** The parts, with what makes curves. */
export const fetchCurves = () => Promise.all([import("./index"), loadCurves()]).then(([parts]) => parts);

export const Shelf = lazily(() => fetchCurves().then((parts) => parts.Shelf));
