//! Coordinates: positions, and lists of them within lists.

use std::fmt;

use glam::DVec2;
use serde::Deserialize;
use serde::de::{DeserializeSeed, Deserializer, Error, IgnoredAny, MapAccess, SeqAccess, Visitor};

use super::super::gather::Line;
use super::evidence::Crs;
use super::found::Found;

/// Behind x and y a position has a height and a time at most.
const MOST_BESIDE: usize = 2;

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
