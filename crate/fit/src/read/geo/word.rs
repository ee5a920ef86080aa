//! Words and numbers as names, and what the properties of an object say.

use std::fmt;

use serde::Deserialize;
use serde::de::{DeserializeSeed, Deserializer, IgnoredAny, MapAccess, SeqAccess, Visitor};

use super::super::text::short;

/// The most letters of a name, which may be an address.
const MAX_LETTERS: usize = 80;
/// The most letters that are listed.
const MAX_NAME: usize = 40;

/// A word or a number as a short text; of a list the first.
#[derive(Clone, Copy)]
pub struct Word;

impl<'de> DeserializeSeed<'de> for Word {
    type Value = Option<String>;

    fn deserialize<D: Deserializer<'de>>(self, from: D) -> Result<Option<String>, D::Error> {
        from.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for Word {
    type Value = Option<String>;

    fn expecting(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        to.write_str("a name")
    }

    fn visit_unit<E>(self) -> Result<Option<String>, E> {
        Ok(None)
    }

    fn visit_bool<E>(self, value: bool) -> Result<Option<String>, E> {
        Ok(Some(value.to_string()))
    }

    fn visit_f64<E>(self, value: f64) -> Result<Option<String>, E> {
        Ok(Some(short(&value.to_string(), MAX_NAME)))
    }

    fn visit_i64<E>(self, value: i64) -> Result<Option<String>, E> {
        Ok(Some(value.to_string()))
    }

    fn visit_u64<E>(self, value: u64) -> Result<Option<String>, E> {
        Ok(Some(value.to_string()))
    }

    fn visit_str<E>(self, value: &str) -> Result<Option<String>, E> {
        Ok(Some(short(value, MAX_LETTERS)))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Option<String>, A::Error> {
        let mut first = None;
        while let Some(next) = seq.next_element_seed(Shallow)? {
            first = first.or(next);
        }
        Ok(first)
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Option<String>, A::Error> {
        while map.next_entry::<IgnoredAny, IgnoredAny>()?.is_some() {}
        Ok(None)
    }
}

/// A word within a list, or nothing where there are lists in it.
struct Shallow;

impl<'de> DeserializeSeed<'de> for Shallow {
    type Value = Option<String>;

    fn deserialize<D: Deserializer<'de>>(self, from: D) -> Result<Option<String>, D::Error> {
        from.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for Shallow {
    type Value = Option<String>;

    fn expecting(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        to.write_str("a name")
    }

    fn visit_unit<E>(self) -> Result<Option<String>, E> {
        Ok(None)
    }

    fn visit_bool<E>(self, _: bool) -> Result<Option<String>, E> {
        Ok(None)
    }

    fn visit_f64<E>(self, _: f64) -> Result<Option<String>, E> {
        Ok(None)
    }

    fn visit_i64<E>(self, _: i64) -> Result<Option<String>, E> {
        Ok(None)
    }

    fn visit_u64<E>(self, _: u64) -> Result<Option<String>, E> {
        Ok(None)
    }

    fn visit_str<E>(self, value: &str) -> Result<Option<String>, E> {
        Ok(Some(short(value, MAX_NAME)))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Option<String>, A::Error> {
        while seq.next_element::<IgnoredAny>()?.is_some() {}
        Ok(None)
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Option<String>, A::Error> {
        while map.next_entry::<IgnoredAny, IgnoredAny>()?.is_some() {}
        Ok(None)
    }
}

/// What properties say: a name, whether they are those of a picture, and a system of coordinates.
#[derive(Default)]
pub struct Properties {
    pub name: Option<String>,
    pub crs: Option<String>,
    /// `QuPath` wrote them: coordinates are pixels, and y goes down.
    pub picture: bool,
    deep: bool,
    is_object: bool,
}

/// What `QuPath` says of its objects.
const PICTURE_WORDS: [&str; 7] = ["annotation", "detection", "cell", "tile", "tma_core", "true", "false"];

#[derive(Deserialize)]
#[serde(field_identifier)]
enum Key {
    #[serde(rename = "name", alias = "NAME", alias = "Name")]
    Name,
    /// A name where there is none.
    #[serde(rename = "label", alias = "title")]
    Title,
    /// Of a system of coordinates.
    #[serde(rename = "href", alias = "code")]
    Code,
    #[serde(rename = "classification")]
    Classification,
    #[serde(rename = "objectType", alias = "isLocked", alias = "object_type")]
    Picture,
    #[serde(rename = "properties")]
    Properties,
    #[serde(other)]
    Other,
}

impl<'de> DeserializeSeed<'de> for Properties {
    type Value = Self;

    fn deserialize<D: Deserializer<'de>>(self, from: D) -> Result<Self, D::Error> {
        from.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for Properties {
    type Value = Self;

    fn expecting(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        to.write_str("properties")
    }

    fn visit_unit<E>(self) -> Result<Self, E> {
        Ok(self)
    }

    fn visit_bool<E>(self, _: bool) -> Result<Self, E> {
        Ok(self)
    }

    fn visit_f64<E>(self, _: f64) -> Result<Self, E> {
        Ok(self)
    }

    fn visit_i64<E>(self, _: i64) -> Result<Self, E> {
        Ok(self)
    }

    fn visit_u64<E>(self, _: u64) -> Result<Self, E> {
        Ok(self)
    }

    fn visit_str<E>(mut self, value: &str) -> Result<Self, E> {
        self.name = Some(short(value, MAX_LETTERS));
        Ok(self)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Self, A::Error> {
        while seq.next_element::<IgnoredAny>()?.is_some() {}
        Ok(self)
    }

    fn visit_map<A: MapAccess<'de>>(mut self, mut map: A) -> Result<Self, A::Error> {
        let mut class = None;
        self.is_object = true;
        while let Some(key) = map.next_key()? {
            match key {
                Key::Name if self.name.is_none() => self.name = map.next_value_seed(Word)?,
                Key::Code if self.deep => self.name = map.next_value_seed(Word)?.or(self.name),
                Key::Title if class.is_none() => class = map.next_value_seed(Word)?,
                Key::Classification if !self.deep => {
                    let inner = Self { deep: true, ..Self::default() };
                    let inner = map.next_value_seed(inner)?;
                    self.picture |= inner.is_object;
                    class = inner.name;
                }
                Key::Properties if !self.deep => {
                    let inner = Self { deep: true, ..Self::default() };
                    self.crs = map.next_value_seed(inner)?.name;
                }
                Key::Picture => {
                    let word = map.next_value_seed(Word)?;
                    self.picture |= word.is_some_and(|word| PICTURE_WORDS.contains(&word.as_str()));
                }
                _ => {
                    map.next_value::<IgnoredAny>()?;
                }
            }
        }
        self.name = self.name.or(class);
        Ok(self)
    }
}
