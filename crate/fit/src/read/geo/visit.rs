//! GeoJSON as it is read: each line goes to what has been found so far, and no tree is built. Whether coordinates count
//! is said by a type that may come after them, and what they are called by properties that may, too: until then they
//! are held as if they counted.

use std::fmt;

use glam::DVec2;
use serde::Deserialize;
use serde::de::{DeserializeSeed, Deserializer, Error, IgnoredAny, MapAccess, SeqAccess, Visitor};

use super::super::gather::{About, Gathered, Line};
use super::evidence::{Crs, Evidence};
use super::topology::{ArcNest, Arcs};
use super::word::{Properties, Word};

/// Longer ids of pictures are random letters.
const MAX_ID: usize = 20;
/// Behind x and y a position has a height and a time at most.
const MOST_BESIDE: usize = 2;

/// What a line is called.
pub struct Label {
    pub name: Option<String>,
    /// How many lines came before it.
    pub index: usize,
    pub closed: bool,
    /// The number of its class, which is named elsewhere.
    pub class: Option<i64>,
}

/// The lines of a part of the text.
#[derive(Default)]
pub struct Found {
    pub gathered: Gathered<Label>,
    pub count: usize,
    pub evidence: Evidence,
}

impl Found {
    pub fn take(&mut self, line: &Line, closed: bool) {
        if line.count > 0 {
            let label = Label { name: None, index: self.count, closed: false, class: None };
            self.gathered.take(line, About { label, closed, ground: false });
            self.count += 1;
        }
    }

    pub fn absorb(&mut self, mut later: Self) {
        self.evidence.absorb(&later.evidence, later.count > 0);
        if later.count == 0 {
            return;
        }
        later.gathered.kept.iter_mut().for_each(|kept| kept.label.index += self.count);
        self.gathered.absorb(later.gathered);
        self.count += later.count;
    }

    /// Names those that have no name yet.
    pub fn name(&mut self, name: &str) {
        for kept in &mut self.gathered.kept {
            kept.label.name.get_or_insert_with(|| name.to_owned());
        }
    }
}

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

/// The way along a line, which may cross the date line.
#[derive(Default)]
pub struct Walk {
    ends: Option<(DVec2, DVec2)>,
    turned: f64,
}

impl Walk {
    /// Where the next point lies: across the date line the numbers jump, the coast does not.
    pub fn step(&mut self, p: DVec2, globe: bool) -> DVec2 {
        if let (true, Some((_, before))) = (globe, self.ends) {
            self.turned -= 360.0 * ((p.x - before.x) / 360.0).round();
        }
        self.ends = Some((self.ends.map_or(p, |(start, _)| start), p));
        DVec2::new(p.x + self.turned, p.y)
    }

    pub fn returns(&self) -> bool {
        self.ends.is_some_and(|(start, end)| start == end)
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

    /// A position by its names: `{"x": 1, "y": 2}`.
    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Item, A::Error> {
        let Some((position, globe)) = named_position(map)? else { return Ok(Item::Other) };
        if globe {
            self.found.evidence.crs.get_or_insert(Crs::Degrees);
        }
        Ok(Item::Position(position))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Item, A::Error> {
        let Self { globe, found } = self;
        let mut line = Line::default();
        let mut walk = Walk::default();
        let mut first = true;
        while let Some(item) = seq.next_element_seed(Nest { globe, found: &mut *found })? {
            match item {
                Item::Number(x) if first => {
                    // A position: what comes after its second number is height and time.
                    let y = seq.next_element_seed(Nest { globe, found: &mut Found::default() })?;
                    let mut more = 0;
                    while seq.next_element::<IgnoredAny>()?.is_some() {
                        more += 1;
                    }
                    found.evidence.long |= more > MOST_BESIDE;
                    return Ok(match y {
                        _ if more > MOST_BESIDE => Item::Other,
                        Some(Item::Number(y)) if x.abs() <= 1e100 && y.abs() <= 1e100 => {
                            Item::Position(DVec2::new(x, y))
                        }
                        _ => Item::Other,
                    });
                }
                Item::Position(p) => {
                    found.evidence.take(p);
                    line.push(walk.step(p, globe));
                }
                Item::Number(_) | Item::Other => {}
            }
            first = false;
        }
        found.take(&line, walk.returns());
        Ok(Item::Other)
    }
}

#[derive(Clone, Copy, Deserialize)]
#[serde(field_identifier)]
enum Coordinate {
    #[serde(rename = "x", alias = "X")]
    X,
    #[serde(rename = "y", alias = "Y")]
    Y,
    #[serde(rename = "lon", alias = "lng", alias = "longitude")]
    Longitude,
    #[serde(rename = "lat", alias = "latitude")]
    Latitude,
    #[serde(other)]
    Other,
}

/// A position by the names of its coordinates, and whether they are those of the globe.
fn named_position<'de, A: MapAccess<'de>>(mut map: A) -> Result<Option<(DVec2, bool)>, A::Error> {
    let (mut x, mut y, mut globe) = (None, None, false);
    while let Some(key) = map.next_key()? {
        let place = match key {
            Coordinate::X | Coordinate::Longitude => &mut x,
            Coordinate::Y | Coordinate::Latitude => &mut y,
            Coordinate::Other => {
                map.next_value::<IgnoredAny>()?;
                continue;
            }
        };
        globe |= matches!(key, Coordinate::Longitude | Coordinate::Latitude);
        let item = map.next_value_seed(Nest { globe: false, found: &mut Found::default() })?;
        if let Item::Number(value) = item {
            *place = Some(value).filter(|value| value.abs() <= 1e100);
        }
    }
    Ok(x.zip(y).map(|position| (DVec2::from(position), globe)))
}
