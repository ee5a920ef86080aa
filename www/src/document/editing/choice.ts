/** A shape is about to be chosen: the browser's back button will lead to what is there now. */

let begin: () => void = () => {};

/** Who is told of it. */
export function onChoice(told: () => void): void {
  begin = told;
}

export const beginChoice = (): void => begin();
