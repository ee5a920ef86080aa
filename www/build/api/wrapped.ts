/** A sample as a function of the console and the page that it writes to; what it imports stays before it. */
export function wrapped(code: string): string {
  const [imports = "", ...rest] = code.split("\n\n");
  if (/^(?!import )/m.test(imports))
    throw new Error(`a sample begins with its imports and an empty line: ${code}`);
  return `${imports}\nexport default async function (console, document) {\n${rest.join("\n\n")}}\n`;
}
