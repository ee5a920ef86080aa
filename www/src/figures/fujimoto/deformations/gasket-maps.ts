import type { Parameter } from "../../kit/frame/frame";
import { tex } from "../../kit/notation/tex";

/** The maps of the gasket that is bent, as a page lists them. */
export const GASKET_MAPS: Parameter = {
  name: "Maps",
  value: [
    tex`f_i(x) = \frac{1}{2} x + c_i`,
    tex`c_1 = (0, 0)`,
    tex`c_2 = (\frac{1}{2}, 0)`,
    tex`c_3 = (0, \frac{1}{2})`,
  ],
};
