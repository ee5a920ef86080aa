// What `www/build/element-parts.ts` and `view.config.ts` beside it make.

/** A worker as the text of its program. */
declare module "*?program" {
  const text: string;
  export default text;
}

/** A part of the module that decides and proves, packed. */
declare module "frond-proof?part=*" {
  export const text: string;
}
