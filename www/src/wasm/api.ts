/** The types shared with the Rust side, under one roof: `crate/web/src/api.d.ts` is where they are promised. */
export type * from "../../../crate/web/src/api.d.ts";
