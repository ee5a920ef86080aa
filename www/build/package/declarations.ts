/** Reads the declarations that wasm-bindgen writes: what is exported, and where in the text its types stand. */
import type { ESTree } from "vite";
import { type Exported, exportedIn } from "../declared.ts";

/** A type, as values are compared with it. */
export type Schema =
  | "number"
  | "string"
  | "boolean"
  | "nothing"
  | "anything"
  | "function"
  | { is: string | number | boolean }
  | { list: Schema }
  | { row: Schema[]; least: number }
  | { object: Record<string, Schema>; optional: string[] }
  | { any: Schema[] }
  | { all: Schema[] }
  | { named: string }
  | { without: Schema; keys: string[] }
  | { partly: Schema }
  /** An instance of a class of the platform, such as a typed array. */
  | { instance: string };

export interface Span {
  start: number;
  end: number;
}

export interface Parameter {
  name: string;
  optional: boolean;
  type: Schema;
  at: Span;
}

export interface Call {
  name: string;
  parameters: Parameter[];
  /** Of the comment before it, or of itself. */
  start: number;
  /** Of what stands between its brackets. */
  inside: Span;
  returns: Span;
  end: number;
  kind: "function" | "constructor" | "method" | "static";
}

export interface Class {
  name: string;
  start: number;
  end: number;
  /** Neither `free` nor what disposes. */
  calls: Call[];
  getters: string[];
  /** Whether it may be made by `new`. */
  made: boolean;
}

export interface Declarations {
  types: Map<string, { schema: Schema } & Span>;
  functions: Call[];
  classes: Class[];
}

/** What a class of the platform is named; all else in capitals is a type of the package. */
const PLATFORM =
  /^(?:(?:Big)?(?:Int|Uint|Float)\d+(?:Clamped)?Array|ArrayBuffer|HTMLCanvasElement|OffscreenCanvas|URL)$/;

function schemaOf(type: ESTree.TSType): Schema {
  switch (type.type) {
    case "TSNumberKeyword":
      return "number";
    case "TSStringKeyword":
      return "string";
    case "TSBooleanKeyword":
      return "boolean";
    case "TSUndefinedKeyword":
    case "TSNullKeyword":
    case "TSVoidKeyword":
      return "nothing";
    case "TSAnyKeyword":
    case "TSUnknownKeyword":
      return "anything";
    case "TSFunctionType":
      return "function";
    case "TSParenthesizedType":
    case "TSTypeOperator":
      return schemaOf(type.typeAnnotation);
    case "TSUnionType":
      return { any: type.types.map(schemaOf) };
    case "TSIntersectionType":
      return { all: type.types.map(schemaOf) };
    case "TSArrayType":
      return { list: schemaOf(type.elementType) };
    case "TSTupleType":
      return rowOf(type.elementTypes);
    case "TSTypeLiteral":
      return fieldsOf(type.members);
    case "TSTypeReference":
      return namedBy(type.typeName, type.typeArguments?.params ?? []);
    case "TSLiteralType": {
      const { literal } = type;
      if (literal.type === "Literal" && ["string", "number", "boolean"].includes(typeof literal.value))
        return { is: literal.value as string | number | boolean };
    }
  }
  throw new Error(`a type of the form ${type.type} is not expected in declarations`);
}

function namedBy(name: ESTree.Node, given: ESTree.TSType[]): Schema {
  if (name.type !== "Identifier") return "anything";
  const [one = "anything", keys] = given.map(schemaOf);
  switch (name.name) {
    case "Array":
    case "ArrayLike":
    case "ReadonlyArray":
      return { list: one };
    case "Partial":
      return { partly: one };
    case "Omit":
      return { without: one, keys: literals(keys) };
    case "Exclude":
      return one;
    case "Promise":
    case "RequestInfo":
    case "Response":
      return "anything";
  }
  return PLATFORM.test(name.name) ? { instance: name.name } : { named: name.name };
}

function literals(type: Schema | undefined): string[] {
  if (typeof type !== "object") return [];
  if ("is" in type) return [String(type.is)];
  return "any" in type ? type.any.flatMap(literals) : [];
}

function fieldsOf(members: ESTree.TSSignature[]): Schema {
  const object: Record<string, Schema> = {};
  const optional: string[] = [];
  for (const member of members) {
    if (member.type !== "TSPropertySignature" && member.type !== "TSMethodSignature")
      throw new Error(`a field of the form ${member.type} is not expected in declarations`);
    const { key } = member;
    const name = key.type === "Identifier" ? key.name : key.type === "Literal" ? String(key.value) : "";
    if (member.optional) optional.push(name);
    const type = member.type === "TSPropertySignature" ? member.typeAnnotation?.typeAnnotation : null;
    object[name] = type ? schemaOf(type) : "function";
  }
  return { object, optional };
}

function rowOf(elements: ESTree.TSTupleElement[]): Schema {
  let least = 0;
  const row = elements.map((element, i) => {
    const isLabelled = element.type === "TSNamedTupleMember";
    if (!(isLabelled ? element.optional : element.type === "TSOptionalType")) least = i + 1;
    if (isLabelled) return schemaOf(element.elementType as ESTree.TSType);
    return schemaOf(element.type === "TSOptionalType" ? element.typeAnnotation : (element as ESTree.TSType));
  });
  return { row, least };
}

type Called = { params: ESTree.ParamPattern[]; returnType?: ESTree.TSTypeAnnotation | null };

/** `part` is of the function or of the member of a class whose parameters `called` has. */
function callOf(
  text: string,
  part: Omit<Exported, "node" | "members">,
  called: Called,
  kind: Call["kind"],
): Call {
  const type = called.returnType?.typeAnnotation;
  const close = text.lastIndexOf(")", type?.start ?? part.end);
  return {
    name: part.name,
    parameters: called.params.map((parameter) => {
      const given = parameter.type === "Identifier" ? parameter.typeAnnotation?.typeAnnotation : null;
      if (parameter.type !== "Identifier" || !given)
        throw new Error(`${part.name} has a parameter without a type`);
      const { name, optional = false } = parameter;
      return { name, optional, type: schemaOf(given), at: { start: given.start, end: given.end } };
    }),
    start: part.from,
    inside: { start: text.indexOf("(", part.start) + 1, end: close },
    returns: type ? { start: type.start, end: type.end } : { start: close + 1, end: close + 1 },
    end: part.end,
    kind,
  };
}

/** All that a file declares. What it imports is passed over. */
export function declarations(text: string): Declarations {
  const found: Declarations = { types: new Map(), functions: [], classes: [] };
  for (const one of exportedIn(text)) {
    const { node, name, from: start, end } = one;
    if (node.type === "TSInterfaceDeclaration") {
      const bases = node.extends.map(({ expression, typeArguments }) =>
        namedBy(expression, typeArguments?.params ?? []),
      );
      const own = fieldsOf(node.body.body);
      found.types.set(name, { schema: bases.length > 0 ? { all: [...bases, own] } : own, start, end });
    } else if (node.type === "TSTypeAliasDeclaration")
      found.types.set(name, { schema: schemaOf(node.typeAnnotation), start, end });
    else if (node.type === "TSDeclareFunction") found.functions.push(callOf(text, one, node, "function"));
    else if (node.type === "ClassDeclaration") found.classes.push(classOf(text, one));
    else throw new Error(`${name}: a ${node.type} is not expected in declarations`);
  }
  return found;
}

function classOf(text: string, { name, from, end, members }: Exported): Class {
  const made: Class = { name, start: from, end, calls: [], getters: [], made: true };
  for (const member of members) {
    const { node } = member;
    if (node.type === "PropertyDefinition" && node.readonly) made.getters.push(member.name);
    else if (node.type === "MethodDefinition" && (node.kind === "constructor" || node.kind === "method")) {
      if (node.accessibility === "private") made.made = false;
      else if (member.name !== "free") {
        const kind = node.kind === "constructor" ? "constructor" : node.static ? "static" : "method";
        made.calls.push(callOf(text, member, node.value, kind));
      }
    } else throw new Error(`${name}.${member.name}: a ${node.type} is not expected in declarations`);
  }
  return made;
}
