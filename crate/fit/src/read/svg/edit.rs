//! Changes of a text, at places that were found in it.

use std::ops::Range;

/// A place in the text where letters are replaced.
pub type Edit = (Range<usize>, String);

pub fn edited(text: &str, mut edits: Vec<Edit>) -> String {
    edits.sort_by_key(|(range, _)| (range.start, range.end));
    let mut written = String::with_capacity(text.len() + 64 * edits.len());
    let mut at = 0;
    for (range, new) in edits {
        if range.start >= at && range.end <= text.len() {
            written.push_str(&text[at..range.start]);
            written.push_str(&new);
            at = range.end;
        }
    }
    written.push_str(&text[at..]);
    written
}
