//! Numbers in the attributes of a flame, also where a program wrote them as its country does: `0,5`.

use crate::text::{number, short};

/// Reads numbers, and remembers whether any had a comma for its point.
#[derive(Default)]
pub struct Numbers {
    /// Whether one was written so.
    pub commas: bool,
}

impl Numbers {
    /// A finite number.
    pub fn one(&mut self, word: &str) -> Option<f64> {
        let word = word.trim();
        if let Some(found) = number(word) {
            return Some(found);
        }
        // No number is as long as this, and what is copied stays short.
        if word.len() > 400 {
            return None;
        }
        let plain = word.replace('\u{2212}', "-");
        // A comma beside a point parts thousands, or numbers: which of them is not guessed.
        if plain.matches(',').count() != 1 || plain.contains('.') {
            return number(&plain);
        }
        let found = number(&plain.replace(',', "."));
        self.commas |= found.is_some();
        found
    }

    /// The six numbers of an affine map of a plane, in their order. They stand between blanks; commas after them, or
    /// instead of blanks, say nothing.
    pub fn six(&mut self, key: &str, text: &str) -> Result<[f64; 6], String> {
        let blank = |c: char| c.is_whitespace() || c == ';';
        let listed = !text.trim().contains(blank) && text.matches(',').count() > 1;
        let mut words = text
            .split(|c: char| blank(c) || (listed && c == ','))
            .map(|word| word.trim_end_matches(','))
            .filter(|word| !word.is_empty());
        let mut six = [0.0; 6];
        for place in &mut six {
            let word = words.next().unwrap_or_default();
            *place =
                self.one(word).ok_or_else(|| format!("{key}=\"{}\" is not six numbers.", short(text, 60)))?;
        }
        match words.next() {
            None => Ok(six),
            Some(_) => Err(format!("{key}=\"{}\" is more than six numbers.", short(text, 60))),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_comma_is_a_point_where_it_can_be_nothing_else() {
        for (word, wanted, commas) in [
            (" 0,5 ", Some(0.5), true),
            ("-1,25e-3", Some(-1.25e-3), true),
            (",5", Some(0.5), true),
            ("\u{2212}0,5", Some(-0.5), true),
            ("\u{2212}2", Some(-2.0), false),
            ("0.5", Some(0.5), false),
            ("1.234,5", None, false),
            ("1,234,5", None, false),
            ("a,5", None, false),
            (",", None, false),
            ("1,0e999", None, false),
        ] {
            let mut numbers = Numbers::default();
            assert_eq!((numbers.one(word), numbers.commas), (wanted, commas), "{word}");
        }
    }

    #[test]
    fn six_numbers_are_parted_by_blanks_or_commas() {
        for text in [
            "0.5 0 0 -1 2 3",
            "0,5 0 0 -1 2 3",
            "0,5, 0, 0, -1, 2, 3",
            " 0.5,0,0,-1,2,3 ",
            "0,5;0;0;-1;2;3",
            "0.5\n0\t0\u{a0}-1 2 3",
        ] {
            assert_eq!(Numbers::default().six("coefs", text), Ok([0.5, 0.0, 0.0, -1.0, 2.0, 3.0]), "{text}");
        }
        for (text, why) in [
            ("1 2 3", "is not six numbers"),
            ("", "is not six numbers"),
            ("1 2 3 4 5 6 7", "is more than six"),
            // Whole numbers with commas, or broken ones without blanks: twelve words might be either.
            ("0,5,0,0,0,0,5,0,0,0", "is more than six"),
        ] {
            let told = Numbers::default().six("coefs", text).unwrap_err();
            assert!(told.contains(why), "{text}: {told}");
        }
    }
}
