/** Reads the declarations that wasm-bindgen writes: what is exported, and where in the text its types stand. */

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

interface Token extends Span {
  text: string;
  /** Where the comment before it begins, or the token itself. */
  from: number;
}

const TOKEN = /\s+|\/\*[\s\S]*?\*\/|\/\/[^\n]*|"(?:[^"\\]|\\.)*"|'(?:[^'\\]|\\.)*'|[\w$]+|=>|[\s\S]/g;

function tokens(text: string): Token[] {
  const found: Token[] = [];
  let comment = -1;
  for (const { 0: part, index } of text.matchAll(TOKEN)) {
    if (part.startsWith("/*")) comment = index;
    else if (!part.startsWith("//") && part.trim() !== "") {
      found.push({ text: part, start: index, end: index + part.length, from: comment < 0 ? index : comment });
      comment = -1;
    }
  }
  return found;
}

/** What a class of the platform is named; all else in capitals is a type of the package. */
const PLATFORM =
  /^(?:(?:Big)?(?:Int|Uint|Float)\d+(?:Clamped)?Array|ArrayBuffer|HTMLCanvasElement|OffscreenCanvas|URL)$/;

class Reader {
  readonly #tokens: Token[];
  #at = 0;

  constructor(text: string) {
    this.#tokens = tokens(text);
  }

  get done(): boolean {
    return this.#at >= this.#tokens.length;
  }

  get token(): Token {
    const token = this.#tokens[this.#at];
    if (!token) throw new Error("the declarations end too early");
    return token;
  }

  /** The end of what was read last. */
  get end(): number {
    return this.#tokens[this.#at - 1]?.end ?? 0;
  }

  next(): Token {
    const token = this.token;
    this.#at++;
    return token;
  }

  is(text: string, ahead = 0): boolean {
    return this.#tokens[this.#at + ahead]?.text === text;
  }

  take(text: string): boolean {
    if (!this.is(text)) return false;
    this.#at++;
    return true;
  }

  expect(text: string): void {
    if (!this.take(text)) throw new Error(`"${text}" is missing before "${this.token.text}"`);
  }

  /** Over all to the bracket that closes the one that was opened. */
  skip(open: string, close: string): void {
    for (let depth = 1; depth > 0; ) {
      const { text } = this.next();
      if (text === open) depth++;
      else if (text === close) depth--;
    }
  }

  type(): Schema {
    this.take("|");
    const any = [this.#all()];
    while (this.take("|")) any.push(this.#all());
    return any.length === 1 ? (any[0] as Schema) : { any };
  }

  #all(): Schema {
    const all = [this.#lists()];
    while (this.take("&")) all.push(this.#lists());
    return all.length === 1 ? (all[0] as Schema) : { all };
  }

  #lists(): Schema {
    this.take("readonly");
    let type = this.#one();
    while (this.is("[") && this.is("]", 1)) {
      this.next();
      this.next();
      type = { list: type };
    }
    return type;
  }

  #one(): Schema {
    const { text } = this.next();
    if (text === "{") return this.#object();
    if (text === "[") return this.#row();
    if (text === "(") {
      if (this.is(")") || this.is(":", 1) || this.is("?", 1)) {
        this.skip("(", ")");
        this.expect("=>");
        this.type();
        return "function";
      }
      const type = this.type();
      this.expect(")");
      return type;
    }
    if (/^["']/.test(text)) return { is: JSON.parse(`"${text.slice(1, -1)}"`) as string };
    if (/^\d/.test(text)) return { is: Number(text) };
    if (text === "true" || text === "false") return { is: text === "true" };
    if (text === "number" || text === "string" || text === "boolean") return text;
    if (text === "undefined" || text === "null" || text === "void") return "nothing";
    if (text === "any" || text === "unknown") return "anything";
    return this.#named(text);
  }

  #named(first: string): Schema {
    let name = first;
    while (this.take(".")) name = `${name}.${this.next().text}`;
    const given: Schema[] = [];
    if (this.take("<")) {
      do given.push(this.type());
      while (this.take(","));
      this.expect(">");
    }
    const [one = "anything", keys] = given;
    if (name === "Array" || name === "ArrayLike" || name === "ReadonlyArray") return { list: one };
    if (name === "Partial") return { partly: one };
    if (name === "Omit") return { without: one, keys: literals(keys) };
    if (name === "Exclude") return one;
    if (PLATFORM.test(name)) return { instance: name };
    if (name.includes(".") || name === "Promise" || name === "RequestInfo" || name === "Response")
      return "anything";
    return { named: name };
  }

  #object(): Schema {
    const object: Record<string, Schema> = {};
    const optional: string[] = [];
    while (!this.take("}")) {
      this.take("readonly");
      const key = this.next().text.replaceAll('"', "");
      if (this.take("?")) optional.push(key);
      if (this.take("(")) {
        this.skip("(", ")");
        object[key] = "function";
        if (this.take(":")) this.type();
      } else {
        this.expect(":");
        object[key] = this.type();
      }
      if (!this.take(";")) this.take(",");
    }
    return { object, optional };
  }

  #row(): Schema {
    const row: Schema[] = [];
    let least = 0;
    while (!this.take("]")) {
      const labelled = this.is(":", 1) || (this.is("?", 1) && this.is(":", 2));
      let optional = false;
      if (labelled) {
        this.next();
        optional = this.take("?");
        this.expect(":");
      }
      row.push(this.type());
      if (!labelled) optional = this.take("?");
      if (!optional) least = row.length;
      this.take(",");
    }
    return { row, least };
  }

  /** From the bracket that opens its parameters on. */
  call(name: string, start: number, kind: Call["kind"]): Call {
    this.expect("(");
    const inside = { start: this.end, end: this.end };
    const parameters: Parameter[] = [];
    while (!this.is(")")) {
      const parameter = this.next().text;
      const optional = this.take("?");
      this.expect(":");
      const at = { start: this.token.start, end: 0 };
      const type = this.type();
      at.end = this.end;
      parameters.push({ name: parameter, optional, type, at });
      this.take(",");
    }
    inside.end = this.token.start;
    this.next();
    const returns = { start: this.end, end: this.end };
    if (this.take(":")) {
      returns.start = this.token.start;
      this.type();
      returns.end = this.end;
    }
    this.expect(";");
    return { name, parameters, start, inside, returns, end: this.end, kind };
  }
}

function literals(type: Schema | undefined): string[] {
  if (typeof type !== "object") return [];
  if ("is" in type) return [String(type.is)];
  return "any" in type ? type.any.flatMap(literals) : [];
}

/** All that a file declares. What it imports is passed over. */
export function declarations(text: string): Declarations {
  const reader = new Reader(text);
  const found: Declarations = { types: new Map(), functions: [], classes: [] };
  while (!reader.done) {
    const { from } = reader.token;
    if (reader.take("import")) {
      while (!reader.take(";")) reader.next();
      continue;
    }
    reader.expect("export");
    reader.take("default");
    const { text: kind } = reader.next();
    const name = reader.next().text;
    if (kind === "interface") {
      const all: Schema[] = [];
      if (reader.take("extends")) {
        do all.push(reader.type());
        while (reader.take(","));
      }
      all.push(reader.type());
      const schema = all.length === 1 ? (all[0] as Schema) : { all };
      found.types.set(name, { schema, start: from, end: reader.end });
    } else if (kind === "type") {
      reader.expect("=");
      const schema = reader.type();
      reader.expect(";");
      found.types.set(name, { schema, start: from, end: reader.end });
    } else if (kind === "function") {
      found.functions.push(reader.call(name, from, "function"));
    } else if (kind === "class") {
      found.classes.push(classOf(reader, name, from));
    } else throw new Error(`"export ${kind} ${name}" is not expected in declarations`);
  }
  return found;
}

function classOf(reader: Reader, name: string, start: number): Class {
  const made: Class = { name, start, end: 0, calls: [], getters: [], made: true };
  reader.expect("{");
  while (!reader.take("}")) {
    const { from } = reader.token;
    if (reader.take("private")) made.made = false;
    const isStatic = reader.take("static");
    if (reader.take("readonly")) {
      made.getters.push(reader.next().text);
      reader.expect(":");
      reader.type();
      reader.expect(";");
      continue;
    }
    const { text: member } = reader.next();
    if (member === "[") {
      reader.skip("[", "]");
      reader.call("", from, "method");
      continue;
    }
    const kind = member === "constructor" ? "constructor" : isStatic ? "static" : "method";
    const call = reader.call(member, from, kind);
    if (member !== "free" && (kind !== "constructor" || made.made)) made.calls.push(call);
  }
  made.end = reader.end;
  return made;
}
