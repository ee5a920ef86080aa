// What stands between a caller and the modules: whatever goes wrong in a call is thrown as a FrondError, in
// JavaScript's words. Calls that work are handed on as they are. What the build writes beside it (frond.js and the like)
// names each function with the types of its parameters, as they stand in the declarations.
import { types } from "./guard-types.js";

/** Thrown by every function. `code` is stable, and the message says what to do. */
export class FrondError extends Error {
  constructor(code, message, options) {
    super(message, options);
    this.code = code;
  }

  // Each module, and each worker, makes errors of its own: what tells them is their form.
  static [Symbol.hasInstance](value) {
    // biome-ignore lint/complexity/noThisInStatic: classes that extend this one ask as well
    if (this !== FrondError) {
      // biome-ignore lint/complexity/noThisInStatic: as above
      return Function.prototype[Symbol.hasInstance].call(this, value);
    }
    return value instanceof Error && value.name === "FrondError" && typeof value.code === "string";
  }
}
// As the errors have it that are made elsewhere: on the error itself it would be listed with the code.
Object.defineProperty(FrondError.prototype, "name", {
  value: "FrondError",
  writable: true,
  configurable: true,
});

const wrong = (message, cause) => new FrondError("bad-input", message, cause && { cause });

// What a value is, in words.

function shown(value) {
  if (value === undefined || value === null || typeof value === "boolean") return String(value);
  if (typeof value === "number") return Object.is(value, -0) ? "-0" : String(value);
  if (typeof value === "bigint") return `the BigInt ${String(value).slice(0, 20)}`;
  if (typeof value === "symbol") return "a symbol";
  if (typeof value === "function") return "a function";
  if (typeof value === "string") return value.length > 40 ? "a text" : `the text ${JSON.stringify(value)}`;
  if (Array.isArray(value)) return `a list of ${value.length}`;
  const name = Object.getPrototypeOf(value)?.constructor?.name;
  return typeof name === "string" && name !== "Object" && name !== "" ? `of class ${name}` : "an object";
}

const COUNTS = [
  "no",
  "one",
  "two",
  "three",
  "four",
  "five",
  "six",
  "seven",
  "eight",
  "nine",
  "ten",
  "eleven",
  "twelve",
];

/** What a value is to be, in words. */
function wanted(type) {
  if (type === "number") return "a number";
  if (type === "string") return "a text";
  if (type === "boolean") return "true or false";
  if (type === "nothing") return "null";
  if (type === "function") return "a function";
  if (type === "anything") return "something else";
  if (type.is !== undefined) return JSON.stringify(type.is);
  if (type.instance) return `${/^[AEIOU](?!int)/.test(type.instance) ? "an" : "a"} ${type.instance}`;
  if (type.list) return type.list === "number" ? "a list of numbers" : "a list";
  if (type.row) {
    const count = COUNTS[type.row.length] ?? type.row.length;
    const least = COUNTS[type.least] ?? type.least;
    const range = type.least < type.row.length ? `${least} or ${count}` : count;
    return `a list of ${range}${type.row.every((entry) => entry === "number") ? " numbers" : ""}`;
  }
  if (type.any) {
    const all = [...new Set(type.any.map((one) => wanted(resolved(one))))];
    return all.length < 2 ? all[0] : `${all.slice(0, -1).join(", ")} or ${all.at(-1)}`;
  }
  const keys = Object.keys(fieldsOf(type)?.object ?? {}).filter(
    (key) => !fieldsOf(type).optional.includes(key),
  );
  return keys.length === 0 ? "an object" : `an object with ${keys.slice(0, 4).join(", ")}`;
}

const resolved = (type) => (type.named ? resolved(types[type.named] ?? "anything") : type);

/** The fields of an object's type, or nothing where it is no plain one. */
function fieldsOf(type) {
  const one = resolved(type);
  if (one.object) return one;
  if (one.partly) {
    const all = fieldsOf(one.partly);
    return all && { object: all.object, optional: Object.keys(all.object) };
  }
  if (one.without) {
    const all = fieldsOf(one.without);
    if (!all) return undefined;
    const object = Object.fromEntries(Object.entries(all.object).filter(([key]) => !one.keys.includes(key)));
    return { object, optional: all.optional };
  }
  if (one.all) {
    const parts = one.all.map(fieldsOf).filter(Boolean);
    return {
      object: Object.assign({}, ...parts.map((part) => part.object)),
      optional: parts.flatMap((part) => part.optional),
    };
  }
  return undefined;
}

const isList = (value) => Array.isArray(value) || (ArrayBuffer.isView(value) && !(value instanceof DataView));

/** Entries of a list that are looked at. */
const MOST_ENTRIES = 100_000;

/**
 * Where a value is not of its type: `{ path, type, value, depth }`. `strict`: null does not stand for what is left out.
 */
function mismatch(given, value, path, strict, depth = 0) {
  const type = resolved(given);
  const no = { path, type, value, depth };
  if (type === "anything") return undefined;
  if (type === "nothing") return value === undefined || value === null ? undefined : no;
  if (typeof type === "string") {
    return typeof value === type ? undefined : no;
  }
  if (type.is !== undefined) return value === type.is ? undefined : no;
  if (type.instance) {
    const Class = globalThis[type.instance];
    if (Class === undefined || value instanceof Class) return undefined;
    return Object.prototype.toString.call(value) === `[object ${type.instance}]` ? undefined : no;
  }
  if (type.list) {
    if (!isList(value)) return no;
    for (let i = 0; i < Math.min(value.length, MOST_ENTRIES); i++) {
      const found = mismatch(type.list, value[i], `${path}[${i}]`, strict, depth + 1);
      if (found) return found;
    }
    return undefined;
  }
  if (type.row) {
    if (!isList(value) || value.length > type.row.length || value.length < type.least) return no;
    for (let i = 0; i < value.length; i++) {
      const found = mismatch(type.row[i], value[i], `${path}[${i}]`, strict, depth + 1);
      if (found) return found;
    }
    return undefined;
  }
  if (type.any) {
    const found = type.any.map((one) => mismatch(one, value, path, strict, depth));
    if (found.includes(undefined)) return undefined;
    // What it comes nearest to tells most; where it is none of them, all are named.
    const deepest = found.reduce((most, one) => (one.depth > most.depth ? one : most));
    return deepest.depth > depth ? deepest : no;
  }
  if (typeof value !== "object" || value === null || isList(value)) return no;
  // Of several forms of one object, such as those that a kind tells apart, all that fits one of them fits.
  const several = type.all?.map(resolved).find((one) => one.any);
  if (several && mismatch(several, value, path, strict, depth)) return no;
  const fields = fieldsOf(type);
  for (const [key, field] of Object.entries(fields?.object ?? {})) {
    let inside;
    try {
      inside = value[key];
    } catch {
      return { ...no, path: `${path}.${key}`, type: field, value: undefined };
    }
    if (inside === undefined || (inside === null && !strict)) {
      if (fields.optional.includes(key)) continue;
    }
    const found = mismatch(field, inside, `${path}.${key}`, strict, depth + 1);
    if (found) return found;
  }
  return undefined;
}

/** Entries of a list whose lengths are looked at. */
const MOST_ROWS = 256;
/** No list that a module takes entry by entry is longer; what are many numbers are typed arrays. */
const MOST_LENGTH = 10_000_000;

/** Whether it is a number, a text or the like. */
const isScalar = (type) =>
  ["number", "string", "boolean"].includes(type) ||
  type.is !== undefined ||
  Boolean(type.any?.every((one) => isScalar(resolved(one))));

/**
 * What a module must not be handed. A row that is longer than it may be: it would take the first of its numbers, and no
 * more. A list or an object in place of a number or a text: some parts of a module take in all of it before they refuse
 * it, however long or deep it is.
 */
function unfit(given, value, path) {
  const type = resolved(given);
  if (typeof value !== "object" || value === null) return undefined;
  if (isScalar(type)) return { path, type, value };
  if (type.row && Array.isArray(value)) {
    if (value.length > type.row.length) return { path, type, value };
    for (let i = 0; i < value.length; i++) {
      const found = unfit(type.row[i], value[i], `${path}[${i}]`);
      if (found) return found;
    }
    return undefined;
  }
  if (type.list && Array.isArray(value)) {
    if (value.length > MOST_LENGTH) return { path, type, value };
    for (let i = 0; i < Math.min(value.length, MOST_ROWS); i++) {
      const found = unfit(type.list, value[i], `${path}[${i}]`);
      if (found) return found;
    }
    return undefined;
  }
  for (const [key, field] of Object.entries(fieldsOf(type)?.object ?? {})) {
    let inside;
    try {
      inside = value[key];
    } catch {
      return undefined;
    }
    const found = unfit(field, inside, `${path}.${key}`);
    if (found) return found;
  }
  return undefined;
}

/** Where among the arguments this number is. */
function whereIs(number, value, path, depth = 0) {
  if (typeof value === "number") return Object.is(value, number) ? path : undefined;
  if (typeof value !== "object" || value === null || depth > 8) return undefined;
  const entries = isList(value) ? Array.prototype.entries.call(value) : Object.entries(value);
  let count = 0;
  for (const [key, inside] of entries) {
    if (count++ > MOST_ENTRIES) return undefined;
    const found = whereIs(number, inside, isList(value) ? `${path}[${key}]` : `${path}.${key}`, depth + 1);
    if (found) return found;
  }
  return undefined;
}

/** Words that only those know who have read the modules. */
const INSIDE =
  /\bstruct\b|\bf64\b|\bf32\b|\b[iu](?:8|16|32|64|128|size)\b|unit value|\brust\b|unreachable|null pointer|panick|wasm|JsValue|externref|invalid (?:type|value|length)|\bsequence\b|memory access|table index|missing field|unknown variant|expected/i;

/** What is wrong with the arguments of a call that was refused. */
function diagnosis(name, parameters, args, message, cause) {
  for (const strict of [false, true]) {
    for (const [i, { name: path, type, optional }] of parameters.entries()) {
      if ((optional && (args[i] === undefined || args[i] === null)) || type === "boolean") continue;
      const found = mismatch(type, args[i], path, strict);
      if (found) {
        const { path: at, type: to, value } = found;
        const words = value === undefined ? "is not given" : `is ${shown(value)}`;
        return wrong(`${name}: ${at} must be ${wanted(resolved(to))}, and ${words}.`, cause);
      }
    }
  }
  const number = /`(-?[\d.]+(?:e[+-]?\d+)?|NaN|-?inf(?:inity)?)`/i.exec(message)?.[1];
  const whole = /expected (?:an? )?([iu])(?:8|16|32|64|128|size)\b/.exec(message)?.[1];
  if (number !== undefined && whole !== undefined) {
    const value = Number(number.replace(/^(-?)inf(?:inity)?$/i, "$1Infinity"));
    const at = parameters.map(({ name: path }, i) => whereIs(value, args[i], path)).find(Boolean);
    const to = whole === "u" ? "a whole number from 0 on" : "a whole number";
    return wrong(
      `${name}: ${at ?? "one of the numbers"} must be ${to} that is not too large, and is ${value}.`,
      cause,
    );
  }
  if (INSIDE.test(message)) {
    const names = parameters.map(({ name: path }) => path);
    return wrong(
      `${name}: what was given for ${names.join(", ") || "it"} is not of the form that it must be.`,
      cause,
    );
  }
  return undefined;
}

// Numbers, texts and lists of numbers are made into those that the modules take, which ask for no type.

const isNumeric = (value) =>
  typeof value === "number" ||
  (typeof value === "string" && value.trim() !== "" && !Number.isNaN(Number(value)));

/** Of a list of numbers: which array it becomes; undefined for what is none. */
const flatOf = (type) =>
  type.any?.some((one) => one.list === "number") ? type.any.find((one) => one.instance)?.instance : undefined;

/** A text, or one of several words. */
const isText = (type) => {
  const one = resolved(type);
  return one === "string" || (one.any ?? [one]).every((word) => typeof word.is === "string");
};

function plain(name, { name: path, type, optional }, value) {
  if (value === undefined || value === null) {
    // A module asks for an object where there is one to be had; nothing stands in for a number, a text or a list.
    const needed = type === "number" || isText(type) || flatOf(type) || type.instance?.endsWith("Array");
    if (!optional && needed)
      throw wrong(`${name}: ${path} must be ${wanted(resolved(type))}, and is not given.`);
    return value;
  }
  if (type === "number") {
    if (typeof value === "number") return value;
    if (isNumeric(value) || typeof value === "boolean") return Number(value);
  } else if (isText(type)) {
    if (typeof value === "string") return value;
    if (value instanceof String) return String(value);
  } else if (flatOf(type)) {
    if (value instanceof ArrayBuffer && flatOf(type) === "Uint8Array") return new Uint8Array(value);
    if (ArrayBuffer.isView(value) && !(value instanceof DataView || /^Big/.test(value.constructor?.name)))
      return value;
    if (Array.isArray(value)) {
      for (let i = 0; i < value.length; i++) {
        if (!isNumeric(value[i])) {
          const words = value[i] === undefined ? "is not given" : `is ${shown(value[i])}`;
          throw wrong(`${name}: ${path}[${i}] must be a number, and ${words}: it is one flat list.`);
        }
      }
      return value;
    }
  } else if (type.instance?.endsWith("Array") && !mismatch(type, value, path, false)) {
    return value;
  } else if (type === "boolean") {
    if (typeof value === "boolean" || typeof value === "number") return value;
  } else if (typeof type === "object" && !type.instance?.endsWith("Array")) {
    // What has a length and no entries is no list.
    const list = !resolved(type).list || typeof value[Symbol.iterator] === "function";
    const found = list ? unfit(type, value, path) : { path, type: resolved(type), value };
    if (!found) return value;
    throw wrong(
      `${name}: ${found.path} must be ${wanted(found.type)}${found.type.list && list ? " that is shorter" : ""}, and is ${shown(found.value)}.`,
    );
  }
  throw wrong(`${name}: ${path} must be ${wanted(resolved(type))}, and is ${shown(value)}.`);
}

/** Numbers in a row may be given as one object with their names. */
function inARow(args, row) {
  const given = row && args[row.at];
  if (typeof given !== "object" || given === null || isList(given)) return args;
  return [...args.slice(0, row.at), ...row.names.map((key) => given[key]), ...args.slice(row.at + 1)];
}

/** One module: its functions and classes as they are to be called. `restart` makes it anew after it broke. */
export function guarded({ entry, load, loadSync, current, restart }) {
  const failed = (name, parameters, args, problem) => {
    if (problem instanceof FrondError) {
      if (problem.code !== "bad-input") return problem;
      return diagnosis(name, parameters, args, problem.message, problem) ?? problem;
    }
    const message = String(problem?.message ?? problem);
    const inside =
      problem instanceof WebAssembly.RuntimeError || /recursive use|null pointer passed/.test(message);
    if (inside || /call stack|too much recursion|out of memory|allocation failed/i.test(message)) {
      restart?.();
      return new FrondError(
        "broken",
        `${name} failed: it may have run out of memory, or be wrong. ${restart ? "What was made by new before is lost. Ask for less, or" : "Load the page anew, or"} report what it was given.`,
        { cause: problem },
      );
    }
    // Any error of the bindings is about what was handed to them.
    return diagnosis(name, parameters, args, "expected", problem);
  };

  function run(name, parameters, row, given, made, call) {
    if (current() === undefined)
      throw new FrondError(
        "not-started",
        `Call init() of frond-ifs${entry}, and wait for it, before ${name}.`,
      );
    if (made && !made.__wbg_ptr)
      throw new FrondError("freed", `${name} was called after free(). Make another one by new.`);
    if (made && made.__frond !== current())
      throw new FrondError(
        "broken",
        `${name}: what it belongs to was lost when the module broke. Make another one.`,
      );
    const args = inARow(given, row);
    const plainly = parameters.map((parameter, i) => plain(name, parameter, args[i]));
    try {
      const answer = call(plainly);
      if (typeof answer?.then !== "function") return answer;
      return answer.catch((problem) => {
        throw failed(name, parameters, args, problem);
      });
    } catch (problem) {
      throw failed(name, parameters, args, problem);
    }
  }

  const member = (name, inner, { parameters, row }) =>
    ({
      [name](...args) {
        return run(`${name}()`, parameters, row, args, this, (plainly) => inner.apply(this, plainly));
      },
    })[name];

  return {
    async init(input) {
      try {
        return await load(input);
      } catch (problem) {
        throw notLoaded(entry, problem);
      }
    },
    initSync(input) {
      try {
        return loadSync(input);
      } catch (problem) {
        throw notLoaded(entry, problem);
      }
    },
    call(name, inner, { parameters, row }) {
      return {
        [name]: (...args) =>
          run(`${name}()`, parameters, row, args, undefined, (plainly) => inner(...plainly)),
      }[name];
    },
    /** A class, whose methods are guarded where they are, so that they are of those that a module makes as well. */
    type(name, Inner, { made, calls, statics, getters }) {
      const { prototype } = Inner;
      for (const key of Object.keys(calls)) {
        const value = member(key, prototype[key], calls[key]);
        Object.defineProperty(prototype, key, { value, writable: true, configurable: true });
      }
      for (const key of getters) {
        const { get } = Object.getOwnPropertyDescriptor(prototype, key);
        const guardedGet = function () {
          return run(key, [], undefined, [], this, () => get.call(this));
        };
        Object.defineProperty(prototype, key, { get: guardedGet, configurable: true });
      }
      const { free } = prototype;
      const once = function () {
        if (!this.__wbg_ptr) return;
        // What it was in is not there any more.
        if (this.__frond !== current()) this.__destroy_into_raw();
        else free.call(this);
      };
      for (const key of ["free", ...(Symbol.dispose ? [Symbol.dispose] : [])])
        Object.defineProperty(prototype, key, { value: once, writable: true, configurable: true });
      for (const key of Object.keys(statics)) {
        const inner = Inner[key];
        Inner[key] = (...args) =>
          run(`${name}.${key}()`, statics[key].parameters, statics[key].row, args, undefined, (plainly) =>
            inner.apply(Inner, plainly),
          );
      }
      const Outer = new Proxy(Inner, {
        apply() {
          throw wrong(`${name} is a class: it is made by new.`);
        },
        construct(_, args, target) {
          if (!made)
            throw new FrondError("bad-input", `${name} is not made by new: other functions give it.`);
          return run(`new ${name}()`, made.parameters, made.row, args, undefined, (plainly) =>
            Reflect.construct(Inner, plainly, target),
          );
        },
      });
      Object.defineProperty(prototype, "constructor", { value: Outer, writable: true, configurable: true });
      return Outer;
    },
  };
}

const notLoaded = (entry, problem) =>
  new FrondError(
    "not-loaded",
    `The module of frond-ifs${entry} could not be loaded: ${problem?.message ?? problem}. Is its .wasm file where it is sought, and is it whole?`,
    { cause: problem },
  );

/** A link of a document, or of a morph, that is none: no part of it has a name. */
const isLink = (text) => text === "" || text.split("&").some((part) => /^[\w-]+=/.test(part));

const NO_LINK =
  'This is no link of Frond. One looks like "a=fern&b=tree", or is the whole address of the studio with it.';

/** `decodeScene` never throws for a text: what is no link has a problem, and the document that there is without one. */
export const decoding =
  (decode) =>
  (text, ...rest) => {
    const answer = decode(text, ...rest);
    if (answer.problem === undefined && !isLink(String(text).replace(/^#/, "")))
      answer.problem = { code: "not-a-link", message: NO_LINK };
    return answer;
  };

/** What is made of a link refuses what is none. */
export const ofLink = (Inner) =>
  new Proxy(Inner, {
    construct(target, args, newTarget) {
      const [link] = args;
      if (typeof link === "string" && !isLink(link.slice(link.indexOf("#") + 1)))
        throw new FrondError("not-a-link", NO_LINK);
      return Reflect.construct(target, args, newTarget);
    },
  });

/** Functions that fetch their modules when they are first called. */
export function lazily(modules) {
  const started = new Map();
  const module = (name) => {
    let loading = started.get(name);
    if (!loading) {
      loading = modules[name]().then(async (found) => {
        await found.default();
        return found;
      });
      started.set(name, loading);
      // A download that failed may succeed the next time.
      loading.catch(() => started.delete(name));
    }
    return loading;
  };
  return {
    call:
      (from, name) =>
      async (...args) =>
        (await module(from))[name](...args),
    make:
      (from, name) =>
      async (...args) =>
        new (await module(from))[name](...args),
  };
}
