//! Light in a word of space.

use std::fmt::Write as _;

use super::words::{choice, exactly};
use crate::link::words::{name_of, numbers};
use crate::space::document::{PaintName, SpaceLight};

const PAINTS: [(&str, PaintName); 2] = [("map", PaintName::Map), ("height", PaintName::Height)];

/// Lights that have a number, for short words: what a number stands for never changes.
fn numbered(number: &str) -> Option<SpaceLight> {
    let light = SpaceLight { ambient: 0.25, hollows: 0.35, ..SpaceLight::default() };
    if number == "1" { light.with_finish([0.85, 0.35, 0.8, 0.5, 0.0, 1.0]) } else { None }
}

/// What differs from the light of documents that say nothing of it.
pub(super) fn write_light(word: &mut String, light: &SpaceLight) {
    if numbered("1").as_ref() == Some(light) {
        word.push_str("/f:1");
        return;
    }
    let plain = SpaceLight::default();
    if (light.paint, light.numbers()) != (plain.paint, plain.numbers()) {
        let paint = name_of(&PAINTS, &light.paint);
        let _ = write!(word, "/l:{paint},{}", numbers(&light.numbers()));
    }
    if light.finish() != plain.finish() {
        let _ = write!(word, "/f:{}", numbers(&light.finish()));
    }
}

pub(super) fn read_light(text: &str, before: &SpaceLight) -> Option<SpaceLight> {
    let (paint, rest) = text.split_once(',')?;
    let [side, front, ambient, hollows, fog] = exactly(rest)?;
    let paint = choice(&PAINTS, paint)?;
    Some(SpaceLight { paint, side, front, ambient, hollows, fog, ..before.clone() })
}

pub(super) fn read_finish(text: &str, before: &SpaceLight) -> Option<SpaceLight> {
    if text.contains(',') { before.clone().with_finish(exactly(text)?) } else { numbered(text) }
}
