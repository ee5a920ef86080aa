//! The palette of a flame: 256 colours, in one of three forms that programs have written over the years.
//!
//! `<color index="0" rgb="255 128 0"/>` for each; `<colors count="256" data="00FF8000 ..">`; and
//! `<palette count="256" format="RGB">FF8000 ..</palette>`, where the format RGBA has two digits before each colour.

use crate::colour::{Rgb, read_digits};
use crate::text::number;

/// So many colours are kept.
const COUNT: usize = 256;
/// Digits of a colour, at most.
const DIGITS: usize = 8;

/// What is known of a palette.
#[derive(Default)]
pub struct Palette {
    /// Whether one is told of that may stand elsewhere.
    pub named: bool,
    colours: Vec<Option<Rgb>>,
    /// Digits of a list that is being read, and how many each colour has.
    digits: Vec<u8>,
    each: usize,
    /// Whether what stands between tags belongs to it.
    open: bool,
}

impl Palette {
    /// A tag that says something of it.
    pub fn take<'a>(&mut self, tag: &str, attributes: impl Iterator<Item = (&'a str, &'a str)>) {
        self.named = true;
        let (mut index, mut rgb) = (None, None);
        let whole = !tag.eq_ignore_ascii_case("color");
        self.open = whole;
        if whole {
            self.digits.clear();
            self.each = if tag.eq_ignore_ascii_case("colors") { 8 } else { 6 };
        }
        for (key, value) in attributes {
            match key {
                "index" => index = value.trim().parse::<usize>().ok(),
                "rgb" => rgb = three(value),
                "format" if whole => self.each = if value.eq_ignore_ascii_case("RGBA") { 8 } else { 6 },
                "data" if whole => self.take_text(value),
                _ => {}
            }
        }
        if let (Some(index), Some(rgb)) = (index.filter(|&index| index < COUNT), rgb) {
            if self.colours.len() <= index {
                self.colours.resize(index + 1, None);
            }
            self.colours[index] = Some(rgb);
        }
    }

    /// Another tag begins or ends.
    pub const fn end(&mut self) {
        self.open = false;
    }

    /// What stands between tags; it counts where a list has begun.
    pub fn take_text(&mut self, text: &str) {
        if !self.open {
            return;
        }
        let room = (COUNT * DIGITS).saturating_sub(self.digits.len());
        self.digits.extend(text.bytes().filter(u8::is_ascii_hexdigit).take(room));
    }

    /// The colours at places from 0 to 1; none where there is no palette, or a place of it is missing.
    pub fn colours(&self, places: &[f64]) -> Vec<Rgb> {
        let listed: Vec<Option<Rgb>> = match self.each {
            0 => self.colours.clone(),
            each => {
                self.digits.chunks_exact(each).take(COUNT).map(|it| read_digits(&it[each - 6..])).collect()
            }
        };
        let Some(last) = listed.len().checked_sub(1) else { return Vec::new() };
        let at = |place: &f64| listed[(place.clamp(0.0, 1.0) * last as f64).round() as usize];
        places.iter().map(at).collect::<Option<Vec<_>>>().unwrap_or_default()
    }
}

/// Three numbers from 0 to 255, whole or not.
fn three(text: &str) -> Option<Rgb> {
    let mut words =
        text.split_ascii_whitespace().map(|word| number(word).map(|x| x.clamp(0.0, 255.0).round()));
    let mut next = || words.next().flatten().map(|x| x as u8);
    Some([next()?, next()?, next()?])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A name, its attributes, and what stands behind it.
    type Tag<'a> = (&'a str, &'a [(&'a str, &'a str)], &'a str);

    fn palette(tags: &[Tag<'_>]) -> Palette {
        let mut palette = Palette::default();
        for (tag, attributes, text) in tags {
            palette.take(tag, attributes.iter().copied());
            palette.take_text(text);
        }
        palette
    }

    #[test]
    fn all_three_forms_are_read() {
        let of_old = [
            ("color", &[("index", "0"), ("rgb", "255 0 0")][..], ""),
            ("color", &[("index", "1"), ("rgb", "0 127.6 0")][..], ""),
            ("color", &[("index", "2"), ("rgb", " 0 0 300 ")][..], ""),
        ];
        let list = [("colors", &[("count", "3"), ("data", "00FF0000\n00008000 000000ff")][..], "")];
        let rgb = [("palette", &[("count", "3"), ("format", "RGB")][..], "\n FF0000 008000\n0000FF\n")];
        let rgba = [("palette", &[("format", "RGBA")][..], "00FF00000000800000 0000FF")];
        for tags in [&of_old[..], &list, &rgb, &rgba] {
            let found = palette(tags).colours(&[0.0, 0.5, 1.0, -2.0, 0.3]);
            assert_eq!(found, [[255, 0, 0], [0, 128, 0], [0, 0, 255], [255, 0, 0], [0, 128, 0]], "{tags:?}");
        }
    }

    #[test]
    fn what_is_missing_is_no_colour() {
        assert!(palette(&[]).colours(&[0.0]).is_empty());
        assert!(palette(&[("palette", &[], "ff00")]).colours(&[0.0]).is_empty());
        assert!(palette(&[("color", &[("index", "9"), ("rgb", "1 2 3")], "")]).colours(&[0.0]).is_empty());
        assert!(palette(&[("color", &[("index", "256"), ("rgb", "1 2 3")], "")]).colours(&[0.0]).is_empty());
        assert!(palette(&[("color", &[("index", "0"), ("rgb", "1 2")], "")]).colours(&[0.0]).is_empty());
        let mut behind = palette(&[("palette", &[], "0a0a0a")]);
        behind.end();
        behind.take_text("by Ada");
        assert_eq!(behind.colours(&[1.0]), [[10, 10, 10]]);
        // What stands between tags is a palette only within one, and no more of it is kept than there is room for.
        let mut plain = Palette::default();
        plain.take_text("ffffff");
        assert!(plain.colours(&[0.0]).is_empty());
        let long = palette(&[("palette", &[], &"0a".repeat(1 << 20))]);
        assert_eq!((long.digits.len(), long.colours(&[1.0])), (COUNT * DIGITS, vec![[10, 10, 10]]));
    }
}
