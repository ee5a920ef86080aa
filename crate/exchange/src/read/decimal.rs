//! Decimal commas, told from commas that part numbers.

/// How many numbers a map may have in a line: of the plane or of space, with a weight and a number of its own.
const WIDTHS: [usize; 6] = [6, 7, 8, 12, 13, 14];

/// Whether commas are decimal ones in lines with numbers: no point is anywhere, and each line has as many words as a
/// map has numbers. Taken for commas that part whole numbers, they would make maps that shrink nothing.
pub fn has_decimal_commas(lines: impl Iterator<Item = impl AsRef<str>>) -> bool {
    let mut found = false;
    for line in lines {
        let line = line.as_ref();
        if !line.contains(|c: char| c.is_ascii_digit()) {
            continue;
        }
        if line.contains('.') {
            return false;
        }
        let mut count = 0;
        for word in words(line) {
            let word = word.trim_matches(',');
            let mut parts = word.split(',');
            let digits =
                |part: Option<&str>| part.is_some_and(|part| part.contains(|c: char| c.is_ascii_digit()));
            let (whole, rest) = (parts.next(), parts.next());
            if parts.next().is_some() {
                return false;
            }
            found |= digits(whole) && digits(rest);
            // Labels and words behind are none.
            count += usize::from(digits(whole) && !word.starts_with(char::is_alphabetic));
        }
        if !WIDTHS.contains(&count) {
            return false;
        }
    }
    found
}

fn words(line: &str) -> impl Iterator<Item = &str> {
    line.split(|c: char| c.is_whitespace() || matches!(c, ';' | '|' | '&')).filter(|word| !word.is_empty())
}

/// A word with a point where its decimal comma is, without one that parts it from the next.
pub fn decimal_word(word: &str) -> String {
    word.trim_matches(',').replace(',', ".")
}
