//! GeoJSON as it is read: each line goes to what has been found so far, and no tree is built. Whether coordinates count
//! is said by a type that may come after them, and what they are called by properties that may, too: until then they
//! are held as if they counted.

use std::fmt;

use serde::Deserialize;
use serde::de::{DeserializeSeed, Deserializer, Error, IgnoredAny, MapAccess, SeqAccess, Visitor};

use super::evidence::Crs;
use super::found::Found;
use super::nest::Nest;
use super::topology::{ArcNest, Arcs};
use super::word::{Properties, Word};

/// Longer ids of pictures are random letters.
const MAX_ID: usize = 20;

/// Any object of GeoJSON, as much of it as counts.
#[derive(Clone, Copy)]
pub struct Object<'a> {
    /// Whether coordinates are taken for degrees.
    pub globe: bool,
    /// The lines that `arcs` are numbers of, in TopoJSON.
    pub arcs: Option<&'a Arcs>,
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
    Crs,
    CoordRefSys,
    Arcs,
    Objects,
    #[serde(other)]
    Other,
}

impl<'de> DeserializeSeed<'de> for Object<'_> {
    type Value = Found;

    fn deserialize<D: Deserializer<'de>>(self, from: D) -> Result<Found, D::Error> {
        from.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for Object<'_> {
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
                Key::Type => kind = map.next_value_seed(Word)?,
                Key::Id => id = map.next_value_seed(Word)?,
                Key::Properties => {
                    let properties = map.next_value_seed(Properties::default())?;
                    inner.evidence.picture |= properties.picture;
                    name = properties.name;
                }
                Key::Crs | Key::CoordRefSys => {
                    let said = map.next_value_seed(Properties::default())?;
                    inner.evidence.crs = said.crs.or(said.name).as_deref().and_then(Crs::of);
                }
                Key::Geometry => inner.absorb(map.next_value_seed(self)?),
                Key::Features | Key::Geometries => {
                    map.next_value_seed(Objects { of: self, found: &mut inner })?;
                }
                Key::Arcs => match self.arcs {
                    Some(arcs) => {
                        map.next_value_seed(ArcNest { arcs, globe: self.globe, found: &mut own })?;
                    }
                    None => {
                        map.next_value::<IgnoredAny>()?;
                    }
                },
                Key::Objects if self.arcs.is_some() => {
                    map.next_value_seed(Objects { of: self, found: &mut inner })?;
                }
                Key::Coordinates if kind.as_deref().is_none_or(|kind| closes(kind).is_some()) => {
                    map.next_value_seed(Nest { globe: self.globe, found: &mut own })?;
                }
                Key::Coordinates | Key::Objects | Key::Other => {
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
        if let Some(name) = name.or(id.filter(|id| !inner.evidence.picture || id.len() < MAX_ID)) {
            inner.name(&name);
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

/// A list of objects, or an object of named ones.
pub struct Objects<'a> {
    pub of: Object<'a>,
    pub found: &'a mut Found,
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
        while let Some(found) = seq.next_element_seed(self.of)? {
            self.found.absorb(found);
        }
        Ok(())
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<(), A::Error> {
        while let Some(name) = map.next_key_seed(Word)? {
            let mut found = map.next_value_seed(self.of)?;
            if let Some(name) = name {
                found.name(&name);
            }
            self.found.absorb(found);
        }
        Ok(())
    }
}
