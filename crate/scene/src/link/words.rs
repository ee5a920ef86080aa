//! Numbers, names and choices as the words of a link.

use std::fmt::Write as _;

use super::error::LinkError;

/// The longest name of a shape, in characters.
const MAX_NAME: usize = 60;

/// The value among `choices`; the first one is the default.
pub(crate) fn choice<T: Copy>(
    key: &'static str,
    text: Option<&str>,
    choices: &[(&str, T)],
) -> Result<T, LinkError> {
    match text {
        None => Ok(choices[0].1),
        Some(text) => choices
            .iter()
            .find_map(|(name, value)| (*name == text).then_some(*value))
            .ok_or_else(|| damaged(key, text)),
    }
}

/// The name of a value among `choices`.
pub(crate) fn name_of<T: PartialEq>(choices: &[(&'static str, T)], value: &T) -> &'static str {
    choices.iter().find_map(|(name, choice)| (choice == value).then_some(*name)).unwrap_or("")
}

pub(crate) fn read_list<const N: usize>(
    key: &'static str,
    text: &str,
    most: usize,
    fits: impl Fn(&[f64; N]) -> bool,
) -> Result<Vec<[f64; N]>, LinkError> {
    if text.is_empty() {
        return Ok(Vec::new());
    }
    let mut list = Vec::new();
    for part in text.split(';') {
        if list.len() == most {
            return Err(LinkError::Value { key, value: format!("a list of more than {most}") });
        }
        let numbers = read_numbers::<N>(key, part)?;
        if !fits(&numbers) {
            return Err(damaged(key, part));
        }
        list.push(numbers);
    }
    Ok(list)
}

/// Up to four finite numbers.
pub(crate) fn read_some(key: &'static str, text: &str) -> Result<Vec<f64>, LinkError> {
    let numbers: Option<Vec<f64>> =
        text.split(',').take(5).map(|part| part.parse::<f64>().ok().filter(|x| x.is_finite())).collect();
    numbers.filter(|numbers| numbers.len() <= 4).ok_or_else(|| damaged(key, text))
}

pub(crate) fn read_numbers<const N: usize>(key: &'static str, text: &str) -> Result<[f64; N], LinkError> {
    let mut numbers = [0.0; N];
    let mut parts = text.split(',');
    for number in &mut numbers {
        let value = parts.next().and_then(|part| part.parse::<f64>().ok()).filter(|x| x.is_finite());
        *number = value.ok_or_else(|| damaged(key, text))?;
    }
    if parts.next().is_some() { Err(damaged(key, text)) } else { Ok(numbers) }
}

pub(crate) fn within(point: &[f64], most: f64) -> bool {
    point.iter().all(|x| x.abs() <= most)
}

pub(crate) fn damaged(key: &'static str, text: &str) -> LinkError {
    // A short piece is enough to recognise it by.
    let short: String = tidy(text).chars().take(24).collect();
    let dots = if text.chars().count() > 24 { "…" } else { "" };
    LinkError::Value { key, value: format!("“{short}{dots}”") }
}

/// Words with something between them. The standard library's way is compiled anew for each kind of list, a kilobyte
/// each time, and this is on the way to the first picture.
pub(crate) fn joined(words: &[String], by: &str) -> String {
    let mut text = String::new();
    for (i, word) in words.iter().enumerate() {
        if i > 0 {
            text.push_str(by);
        }
        text.push_str(word);
    }
    text
}

/// Numbers with as many digits as bring back the same bits.
pub(crate) fn numbers(list: &[f64]) -> String {
    joined(&list.iter().map(|&x| number(x)).collect::<Vec<_>>(), ",")
}

pub(crate) fn number(x: f64) -> String {
    let text = format!("{x:?}");
    text.strip_suffix(".0").map_or(text.clone(), ToOwned::to_owned)
}

/// Whether a colour is written "#rrggbb".
pub(crate) fn is_colour(text: &str) -> bool {
    text.strip_prefix('#').is_some_and(|hex| hex.len() == 6 && hex.bytes().all(|b| b.is_ascii_hexdigit()))
}

/// Colours "#rrggbb" as a link has them.
pub(crate) fn colour_words(colours: &[String]) -> String {
    let words: Vec<String> = colours.iter().map(|text| text.replacen('#', "", 1)).collect();
    joined(&words, ",")
}

/// The same read again.
pub(crate) fn read_colours(text: &str, most: usize) -> Option<Vec<String>> {
    let colours: Vec<String> = text.split(',').take(most + 1).map(|text| format!("#{text}")).collect();
    (colours.len() <= most && colours.iter().all(|text| is_colour(text))).then_some(colours)
}

/// The most formulas of a shape, and the most characters of one.
const MAX_FORMULAS: usize = 64;
const MAX_FORMULA: usize = 200;

/// Formulas with commas in between, without knowing what they mean. A power is written as two stars.
pub(crate) fn read_formulas(text: &str) -> Option<Vec<String>> {
    let mut formulas = Vec::new();
    for part in unescape(text).split(',') {
        let is_letter = |b: u8| b.is_ascii_lowercase() || b.is_ascii_digit() || b"./()*-+".contains(&b);
        let is_formula = !part.is_empty() && part.len() <= MAX_FORMULA && part.bytes().all(is_letter);
        if !is_formula || formulas.len() == MAX_FORMULAS {
            return None;
        }
        formulas.push(part.to_owned());
    }
    Some(formulas)
}

/// A name without control characters and not too long.
pub(crate) fn tidy(name: &str) -> String {
    name.chars().filter(|c| !c.is_control()).take(MAX_NAME).collect::<String>().trim().to_owned()
}

pub(crate) fn escape(text: &str) -> String {
    let mut escaped = String::new();
    for byte in text.bytes() {
        if byte.is_ascii_alphanumeric() || b"-._~".contains(&byte) {
            escaped.push(char::from(byte));
        } else {
            let _ = write!(escaped, "%{byte:02X}");
        }
    }
    escaped
}

pub(crate) fn unescape(text: &str) -> String {
    let bytes = text.as_bytes();
    let mut plain = Vec::with_capacity(bytes.len());
    let mut i = 0;
    while i < bytes.len() {
        let hex = bytes.get(i + 1..i + 3).and_then(|pair| std::str::from_utf8(pair).ok());
        let byte = hex.filter(|_| bytes[i] == b'%').and_then(|pair| u8::from_str_radix(pair, 16).ok());
        plain.push(byte.unwrap_or(bytes[i]));
        i += if byte.is_some() { 3 } else { 1 };
    }
    String::from_utf8_lossy(&plain).into_owned()
}
