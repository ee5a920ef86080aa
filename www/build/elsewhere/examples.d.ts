/** What the texts of the page become (see `config.ts`). */
declare module "example:react" {
  export function Morph(props: { t: number; onVerdict(words: string): void }): import("preact").JSX.Element;
}

declare module "example:observable" {
  interface Inputs {
    range(bounds: [number, number], options: { label: string }): HTMLElement;
  }
  type Html = (texts: TemplateStringsArray, ...values: unknown[]) => HTMLElement;
  type View = HTMLElement & { t: number };
  export function slider(has: { Inputs: Inputs }): HTMLElement;
  export function view(has: { require(address: string): Promise<unknown>; html: Html }): Promise<View>;
  export function join(has: { view: View; t: number }): void;
}
