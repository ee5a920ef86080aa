//! GeoJSON as it is read: each line goes to what has been found so far, and no tree is built. Whether coordinates count
//! is said by a type that may come after them, and what they are called by properties that may, too: until then they
//! are held as if they counted.

use std::fmt;

use glam::DVec2;
use serde::Deserialize;
use serde::de::{DeserializeSeed, Deserializer, Error, IgnoredAny, MapAccess, SeqAccess, Visitor};

use super::super::gather::{About, Gathered, Line};
use super::super::text::short;

/// What a line is called.
pub struct Label {
    pub name: Option<String>,
    /// How many lines came before it.
    pub index: usize,
    pub closed: bool,
}

/// The lines of a part of the text.
pub struct Found {
    pub gathered: Gathered<Label>,
    count: usize,
    /// Whether all of it may be longitudes and latitudes, which are these.
    pub degrees: bool,
    pub latitudes: (f64, f64),
}

impl Default for Found {
    fn default() -> Self {
        let latitudes = (f64::INFINITY, f64::NEG_INFINITY);
        Self { gathered: Gathered::default(), count: 0, degrees: true, latitudes }
    }
}

impl Found {
    fn take(&mut self, line: &Line, closed: bool) {
        if line.count > 0 {
            let label = Label { name: None, index: self.count, closed: false };
            self.gathered.take(line, About { label, closed, ground: false });
            self.count += 1;
        }
    }

    fn absorb(&mut self, mut later: Self) {
        if later.count == 0 {
            return;
        }
        later.gathered.kept.iter_mut().for_each(|kept| kept.label.index += self.count);
        self.gathered.absorb(later.gathered);
        self.count += later.count;
        self.degrees &= later.degrees;
        self.latitudes = (self.latitudes.0.min(later.latitudes.0), self.latitudes.1.max(later.latitudes.1));
    }
}

/// Any object of GeoJSON, as much of it as counts.
#[derive(Clone, Copy)]
pub struct Object {
    /// Whether coordinates are taken for degrees.
    pub globe: bool,
}

#[derive(Deserialize)]
#[serde(field_identifier, rename_all = "lowercase")]
enum Key {
    Type,
    Coordinates,
    Features,
    Geometries,
    Geometry,
    Id,
    Properties,
    #[serde(other)]
    Other,
}

impl<'de> DeserializeSeed<'de> for Object {
    type Value = Found;

    fn deserialize<D: Deserializer<'de>>(self, from: D) -> Result<Found, D::Error> {
        from.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for Object {
    type Value = Found;

    fn expecting(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        to.write_str("an object of GeoJSON")
    }

    fn visit_unit<E>(self) -> Result<Found, E> {
        Ok(Found::default())
    }

    fn visit_str<E: Error>(self, _: &str) -> Result<Found, E> {
        Err(E::custom("a word stands where an object of GeoJSON should"))
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Found, A::Error> {
        let (mut inner, mut own) = (Found::default(), Found::default());
        let (mut kind, mut name, mut id): (Option<String>, _, _) = (None, None, None);
        while let Some(key) = map.next_key()? {
            match key {
                Key::Type => kind = map.next_value_seed(Word { named: false })?,
                Key::Id => id = map.next_value_seed(Word { named: false })?,
                Key::Properties => name = map.next_value_seed(Word { named: true })?,
                Key::Geometry => inner.absorb(map.next_value_seed(self)?),
                Key::Features | Key::Geometries => {
                    map.next_value_seed(Objects { globe: self.globe, found: &mut inner })?;
                }
                Key::Coordinates if kind.as_deref().is_none_or(|kind| closes(kind).is_some()) => {
                    map.next_value_seed(Nest { globe: self.globe, found: &mut own })?;
                }
                Key::Coordinates | Key::Other => {
                    map.next_value::<IgnoredAny>()?;
                }
            }
        }
        if let Some(closed) = kind.as_deref().and_then(closes) {
            if closed {
                own.gathered.close();
            }
            own.gathered.kept.iter_mut().for_each(|kept| kept.label.closed = closed);
            inner.absorb(own);
        }
        if let Some(name) = name.or(id) {
            for kept in &mut inner.gathered.kept {
                kept.label.name.get_or_insert_with(|| name.clone());
            }
        }
        Ok(inner)
    }
}

/// Whether lines of a type are closed; None where it has none.
fn closes(kind: &str) -> Option<bool> {
    match kind {
        "Polygon" | "MultiPolygon" => Some(true),
        "LineString" | "MultiLineString" => Some(false),
        _ => None,
    }
}

/// A list of objects.
struct Objects<'a> {
    globe: bool,
    found: &'a mut Found,
}

impl<'de> DeserializeSeed<'de> for Objects<'_> {
    type Value = ();

    fn deserialize<D: Deserializer<'de>>(self, from: D) -> Result<(), D::Error> {
        from.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for Objects<'_> {
    type Value = ();

    fn expecting(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        to.write_str("a list of objects")
    }

    fn visit_unit<E>(self) -> Result<(), E> {
        Ok(())
    }

    fn visit_str<E: Error>(self, _: &str) -> Result<(), E> {
        Err(E::custom("a word stands where a list of objects should"))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<(), A::Error> {
        while let Some(found) = seq.next_element_seed(Object { globe: self.globe })? {
            self.found.absorb(found);
        }
        Ok(())
    }
}

/// Coordinates: lists of lists of positions, however deep. Each list of positions is a line.
pub struct Nest<'a> {
    pub globe: bool,
    pub found: &'a mut Found,
}

/// What an item of a list was, once it is read.
pub enum Item {
    Other,
    Number(f64),
    Position(DVec2),
}

impl<'de> DeserializeSeed<'de> for Nest<'_> {
    type Value = Item;

    fn deserialize<D: Deserializer<'de>>(self, from: D) -> Result<Item, D::Error> {
        from.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for Nest<'_> {
    type Value = Item;

    fn expecting(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        to.write_str("coordinates")
    }

    fn visit_f64<E>(self, value: f64) -> Result<Item, E> {
        Ok(Item::Number(value))
    }

    fn visit_i64<E>(self, value: i64) -> Result<Item, E> {
        Ok(Item::Number(value as f64))
    }

    fn visit_u64<E>(self, value: u64) -> Result<Item, E> {
        Ok(Item::Number(value as f64))
    }

    fn visit_unit<E>(self) -> Result<Item, E> {
        Ok(Item::Other)
    }

    fn visit_str<E: Error>(self, _: &str) -> Result<Item, E> {
        Err(E::custom("a word stands where coordinates should"))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Item, A::Error> {
        let Self { globe, found } = self;
        let mut line = Line::default();
        let (mut raw, mut turned): (Option<(DVec2, DVec2)>, f64) = (None, 0.0);
        let mut first = true;
        while let Some(item) = seq.next_element_seed(Nest { globe, found: &mut *found })? {
            match item {
                Item::Number(x) if first => {
                    // A position: what comes after its second number is height and time.
                    let y = seq.next_element_seed(Nest { globe, found: &mut Found::default() })?;
                    while seq.next_element::<IgnoredAny>()?.is_some() {}
                    return Ok(match y {
                        Some(Item::Number(y)) if x.abs() <= 1e100 && y.abs() <= 1e100 => {
                            Item::Position(DVec2::new(x, y))
                        }
                        _ => Item::Other,
                    });
                }
                Item::Position(p) => {
                    found.degrees &= p.x.abs() <= 360.0 && p.y.abs() <= 90.0;
                    found.latitudes = (found.latitudes.0.min(p.y), found.latitudes.1.max(p.y));
                    // Across the date line the numbers jump, the coast does not.
                    if let (true, Some((_, before))) = (globe, raw) {
                        turned -= 360.0 * ((p.x - before.x) / 360.0).round();
                    }
                    raw = Some((raw.map_or(p, |(start, _)| start), p));
                    line.push(DVec2::new(p.x + turned, p.y));
                }
                Item::Number(_) | Item::Other => {}
            }
            first = false;
        }
        found.take(&line, raw.is_some_and(|(start, end)| start == end));
        Ok(Item::Other)
    }
}

/// A word or a number as a short text; with `named`, what the name in an object is.
#[derive(Clone, Copy)]
struct Word {
    named: bool,
}

#[derive(Deserialize)]
#[serde(field_identifier)]
enum NameKey {
    #[serde(rename = "name", alias = "NAME", alias = "Name")]
    Name,
    #[serde(other)]
    Other,
}

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
        Ok(Some(short(&value.to_string(), 40)))
    }

    fn visit_i64<E>(self, value: i64) -> Result<Option<String>, E> {
        Ok(Some(value.to_string()))
    }

    fn visit_u64<E>(self, value: u64) -> Result<Option<String>, E> {
        Ok(Some(value.to_string()))
    }

    fn visit_str<E>(self, value: &str) -> Result<Option<String>, E> {
        Ok(Some(short(value, 40)))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Option<String>, A::Error> {
        while seq.next_element::<IgnoredAny>()?.is_some() {}
        Ok(None)
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Option<String>, A::Error> {
        let mut name = None;
        while let Some(key) = map.next_key()? {
            match key {
                NameKey::Name if self.named && name.is_none() => {
                    name = map.next_value_seed(Self { named: false })?;
                }
                _ => {
                    map.next_value::<IgnoredAny>()?;
                }
            }
        }
        Ok(name)
    }
}
