/**
 * What a file of declarations exports, by the parser that the bundler brings: the files that wasm-bindgen writes, and
 * those of the package that are written by hand.
 */
import { type ESTree, parseSync } from "vite";

/** A statement or the member of a class, and where it stands. */
export interface Part<Node> {
  name: string;
  node: Node;
  start: number;
  end: number;
  /** The comment before it, or nothing. */
  comment: string;
  /** Where that begins, or the part itself. */
  from: number;
}

export type Exported = Part<ESTree.Declaration> & { members: Part<ESTree.ClassElement>[] };

export function exportedIn(text: string): Exported[] {
  const { program, comments, errors } = parseSync("declarations.d.ts", text);
  const [error] = errors;
  if (error) throw new Error(`the declarations cannot be read: ${error.message}`);
  const blocks = new Map(comments.filter(({ type }) => type === "Block").map((one) => [one.end, one.start]));
  const part = <Node>(name: string, node: Node, { start, end }: ESTree.Span): Part<Node> => {
    const before = text.slice(0, start).trimEnd().length;
    const from = blocks.get(before) ?? start;
    return { name, node, start, end, comment: text.slice(from, before), from };
  };
  return program.body.flatMap((statement): Exported[] => {
    const isExport =
      statement.type === "ExportNamedDeclaration" || statement.type === "ExportDefaultDeclaration";
    const node = (isExport ? statement.declaration : null) as ESTree.Declaration | null;
    if (!node || !("id" in node) || node.id?.type !== "Identifier") return [];
    const members =
      node.type === "ClassDeclaration"
        ? node.body.body.flatMap((member) => {
            const named = "key" in member && !member.computed && member.key.type === "Identifier";
            return named ? [part((member.key as ESTree.IdentifierName).name, member, member)] : [];
          })
        : [];
    return [{ ...part(node.id.name, node, statement), members }];
  });
}
