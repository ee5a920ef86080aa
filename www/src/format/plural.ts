/** Numbers and plural forms in the language of the messages. */

const LANGUAGE = "en-GB";

const rules = /* @__PURE__ */ new Intl.PluralRules(LANGUAGE);

/** The form that the language asks for after this count: `plural(2, { one: "1 map", other: "2 maps" })`. */
export function plural<Form>(
  count: number,
  forms: Partial<Record<Intl.LDMLPluralRule, Form>> & { other: Form },
): Form {
  return forms[rules.select(count)] ?? forms.other;
}

const whole = /* @__PURE__ */ new Intl.NumberFormat(LANGUAGE, { maximumFractionDigits: 0 });

/** A count as people write it: 1,773. */
export const countOf = (count: number): string => whole.format(count);

const list = /* @__PURE__ */ new Intl.ListFormat(LANGUAGE, { type: "conjunction" });

/** "A", "A and B", "A, B and C". */
export const listOf = (items: readonly string[]): string => list.format(items);

/** A count and what is counted: "1 map", "1,773 maps". */
export const counted = (count: number, one: string, other: string): string =>
  `${countOf(count)} ${plural(count, { one, other })}`;
