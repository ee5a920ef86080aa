//! The first letters of a word, packed into one number.
//!
//! A lit pixel keeps the first three letters of the piece that it shows: the first gives its colour, the
//! other two shade it. The numbers are ordered as pieces cover each other (later maps lie over earlier
//! ones), 0 is a pixel that is not lit, and all fit the 24 bits that a depth buffer and an `f32` hold.

/// Letters that are kept.
pub const KEPT: u8 = 3;
/// Bits a letter.
const BITS: u32 = 6;
/// One more than the largest code.
pub const CODES: u32 = (1 << (BITS * KEPT as u32)) + 1;

/// The first letters of a word: at most [`KEPT`] of them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Letters {
    packed: u32,
    count: u8,
}

impl Letters {
    /// The empty word.
    pub const NONE: Self = Self { packed: 0, count: 0 };

    /// The word with one more letter (below 64); what comes after the third is forgotten.
    #[inline]
    #[must_use]
    pub fn then(self, letter: usize) -> Self {
        if self.count >= KEPT {
            return self;
        }
        let shift = BITS * u32::from(KEPT - 1 - self.count);
        Self { packed: self.packed | ((letter as u32 & 63) << shift), count: self.count + 1 }
    }

    /// The letters of this word, then those of another: of a piece and a point within it.
    #[inline]
    #[must_use]
    pub fn join(self, inner: Self) -> Self {
        Self {
            packed: self.packed | (inner.packed >> (BITS * u32::from(self.count))),
            count: (self.count + inner.count).min(KEPT),
        }
    }

    /// How many letters there are, at most [`KEPT`].
    #[inline]
    #[must_use]
    pub fn count(self) -> u8 {
        self.count
    }

    /// Twenty bits for the graphics card: the packed letters without the count.
    #[inline]
    #[must_use]
    pub fn packed(self) -> u32 {
        self.packed
    }

    /// The same with the count from bit 18 on.
    #[inline]
    #[must_use]
    pub(crate) fn with_count(self) -> u32 {
        self.packed | u32::from(self.count) << (BITS * u32::from(KEPT))
    }

    /// The code of a pixel that shows a piece with these first letters, from 1; a letter that is not
    /// known counts as the first.
    #[inline]
    #[must_use]
    pub fn code(self) -> u32 {
        self.packed + 1
    }

    /// The letters of a code, or `None` for a pixel that is not lit.
    #[inline]
    #[must_use]
    pub fn of_code(code: u32) -> Option<[usize; KEPT as usize]> {
        let packed = code.checked_sub(1)?;
        Some([2, 1, 0].map(|i| ((packed >> (BITS * i)) & 63) as usize))
    }
}

/// What a pixel keeps of the piece on top: 0 where it is dark, and more the higher the piece lies.
pub trait Code: Copy + Default + Ord {
    /// The same as three letters have it (see [`Letters::code`]).
    fn code(self) -> u32;
    /// That of a piece of a system of so many maps.
    fn of(letters: Letters, maps: usize) -> Self;
}

impl Code for u32 {
    #[inline]
    fn code(self) -> u32 {
        self
    }

    #[inline]
    fn of(letters: Letters, maps: usize) -> Self {
        (letters.packed() & kept_letters(maps)) + 1
    }
}

/// The first three letters of a word in sixteen bits, so that a picture takes little memory. Of more than 32 maps they
/// are the first two: the third tells colours apart by less than any screen shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct ShortCode(u16);

/// Set in the codes of more than 32 maps.
const MANY: u16 = 1 << 15;
const MOST_OF_THREE: usize = 32;

/// The letters of a code that a [`ShortCode`] of so many maps keeps, all bits of each set.
pub(crate) fn kept_letters(maps: usize) -> u32 {
    let all = (1 << (BITS * u32::from(KEPT))) - 1;
    if maps > MOST_OF_THREE { all & !((1 << BITS) - 1) } else { all }
}

impl Code for ShortCode {
    #[inline]
    fn code(self) -> u32 {
        let Some(short) = self.0.checked_sub(1).map(u32::from) else { return 0 };
        let packed = if short & u32::from(MANY) == 0 {
            (short & 0x7c00) << 2 | (short & 0x03e0) << 1 | short & 0x001f
        } else {
            (short & 0x0fff) << 6
        };
        packed + 1
    }

    #[inline]
    fn of(letters: Letters, maps: usize) -> Self {
        let packed = letters.packed();
        let short = if maps > MOST_OF_THREE {
            MANY | (packed >> 6) as u16
        } else {
            (packed >> 2 & 0x7c00 | packed >> 1 & 0x03e0 | packed & 0x001f) as u16
        };
        Self(short + 1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn word(letters: &[usize]) -> Letters {
        letters.iter().fold(Letters::NONE, |word, &letter| word.then(letter))
    }

    #[test]
    fn codes_are_ordered_like_words_and_give_the_letters_back() {
        let words = [[0, 0, 0], [0, 0, 63], [0, 1, 0], [0, 63, 63], [1, 0, 0], [63, 63, 63]];
        let codes = words.map(|w| word(&w).code());
        assert!(codes.is_sorted() && codes[0] == 1 && codes[5] == CODES - 1);
        for (code, letters) in codes.iter().zip(words) {
            assert_eq!(Letters::of_code(*code), Some(letters));
        }
        assert_eq!(Letters::of_code(0), None);
    }

    #[test]
    fn joining_is_writing_one_word_after_the_other() {
        let whole = [5, 17, 40, 3, 9];
        for cut in 0..=whole.len() {
            let joined = word(&whole[..cut]).join(word(&whole[cut..]));
            assert_eq!(joined, word(&whole), "cut after {cut}");
        }
        assert_eq!(word(&[7]).join(Letters::NONE), word(&[7]));
    }

    #[test]
    fn short_codes_are_those_of_three_letters_or_of_two_and_lie_as_they_do() {
        let words = [[0, 0, 0], [0, 0, 31], [0, 5, 0], [17, 3, 30], [31, 31, 31]];
        let shorts = words.map(|letters| ShortCode::of(word(&letters), 32));
        assert!(shorts.is_sorted());
        for (letters, short) in words.iter().zip(shorts) {
            assert_eq!(Letters::of_code(short.code()), Some(*letters));
        }
        let many = [[0, 0, 9], [0, 63, 1], [40, 7, 63], [63, 63, 63]];
        let shorts = many.map(|letters| ShortCode::of(word(&letters), 33));
        assert!(shorts.is_sorted() && ShortCode::default() < shorts[0]);
        for ([first, second, _], short) in many.into_iter().zip(shorts) {
            assert_eq!(Letters::of_code(short.code()), Some([first, second, 0]));
        }
        assert_eq!(ShortCode::default().code(), 0);
    }
}
