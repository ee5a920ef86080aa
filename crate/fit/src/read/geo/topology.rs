//! TopoJSON: lines that objects share, and objects made of their numbers.

use std::cell::Cell;
use std::fmt;

use glam::DVec2;
use serde::Deserialize;
use serde::de::{DeserializeSeed, Deserializer, Error, IgnoredAny, MapAccess, SeqAccess, Visitor};

use super::super::gather::{Line, MAX_KEPT};
use super::super::problem::ReadError;
use super::found::Found;
use super::nest::{Item, Nest, Walk};

/// The most points of all lines that are shared.
pub const MAX_POINTS: usize = MAX_KEPT;
/// The most points of all objects: many may share a line.
const MAX_USED: usize = 1 << 23;

/// The lines that objects share.
#[derive(Default)]
pub struct Arcs {
    points: Vec<DVec2>,
    /// Where each begins.
    starts: Vec<u32>,
    /// Whether there are more than are read.
    too_many: bool,
    /// How many points objects have so far.
    pub used: Cell<usize>,
}

impl Arcs {
    /// An arc, forwards, or backwards where its number is negative.
    fn arc(&self, number: i64) -> Option<(&[DVec2], bool)> {
        let (index, back) = if number < 0 { (!number, true) } else { (number, false) };
        let index = usize::try_from(index).ok()?;
        let start = *self.starts.get(index)? as usize;
        let end = self.starts.get(index + 1).map_or(self.points.len(), |&end| end as usize);
        Some((&self.points[start..end], back))
    }
}

/// Whether a text is TopoJSON, and its lines.
pub fn arcs(text: &str) -> Result<Option<Arcs>, ReadError> {
    if !text.contains("\"Topology\"") {
        return Ok(None);
    }
    let mut from = serde_json::Deserializer::from_str(text);
    // What is miswritten is said by those who read all of it.
    let Ok(Topology { kind: Some(kind), mut arcs, transform }) = Top.deserialize(&mut from) else {
        return Ok(None);
    };
    if kind != "Topology" {
        return Ok(None);
    }
    if arcs.too_many {
        return Err(ReadError::TooMany { what: "points", most: MAX_POINTS });
    }
    if let Some((scale, translate)) = transform {
        for k in 0..arcs.starts.len() {
            let start = arcs.starts[k] as usize;
            let end = arcs.starts.get(k + 1).map_or(arcs.points.len(), |&end| end as usize);
            let mut at = DVec2::ZERO;
            for point in &mut arcs.points[start..end] {
                at += *point;
                *point = at * scale + translate;
            }
        }
    }
    Ok(Some(arcs))
}

#[derive(Default)]
struct Topology {
    kind: Option<String>,
    arcs: Arcs,
    transform: Option<(DVec2, DVec2)>,
}

#[derive(Deserialize)]
#[serde(field_identifier, rename_all = "lowercase")]
enum Key {
    Type,
    Arcs,
    Transform,
    #[serde(other)]
    Other,
}

#[derive(Deserialize)]
struct Transform {
    scale: [f64; 2],
    translate: [f64; 2],
}

struct Top;

impl<'de> DeserializeSeed<'de> for Top {
    type Value = Topology;

    fn deserialize<D: Deserializer<'de>>(self, from: D) -> Result<Topology, D::Error> {
        from.deserialize_map(self)
    }
}

impl<'de> Visitor<'de> for Top {
    type Value = Topology;

    fn expecting(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        to.write_str("TopoJSON")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Topology, A::Error> {
        let mut topology = Topology::default();
        while let Some(key) = map.next_key()? {
            match key {
                Key::Type => topology.kind = map.next_value_seed(super::word::Word)?,
                Key::Arcs => map.next_value_seed(ArcList { arcs: &mut topology.arcs, depth: 0 })?,
                Key::Transform => {
                    let Transform { scale, translate } = map.next_value()?;
                    topology.transform = Some((DVec2::from(scale), DVec2::from(translate)));
                }
                Key::Other => {
                    map.next_value::<IgnoredAny>()?;
                }
            }
        }
        Ok(topology)
    }
}

/// Lists of lists of positions.
struct ArcList<'a> {
    arcs: &'a mut Arcs,
    depth: usize,
}

impl<'de> DeserializeSeed<'de> for ArcList<'_> {
    type Value = ();

    fn deserialize<D: Deserializer<'de>>(self, from: D) -> Result<(), D::Error> {
        from.deserialize_seq(self)
    }
}

impl<'de> Visitor<'de> for ArcList<'_> {
    type Value = ();

    fn expecting(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        to.write_str("arcs")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<(), A::Error> {
        let Self { arcs, depth } = self;
        if depth == 0 {
            let full = |arcs: &Arcs| arcs.starts.len() >= MAX_POINTS || arcs.points.len() >= MAX_POINTS;
            while !full(arcs) {
                // A list has at most a million starts.
                arcs.starts.push(arcs.points.len() as u32);
                if seq.next_element_seed(ArcList { arcs: &mut *arcs, depth: 1 })?.is_none() {
                    arcs.starts.pop();
                    return Ok(());
                }
            }
            arcs.too_many |= seq.next_element::<IgnoredAny>()?.is_some();
            while seq.next_element::<IgnoredAny>()?.is_some() {}
            return Ok(());
        }
        let mut found = Found::default();
        while let Some(item) = seq.next_element_seed(Nest { globe: false, found: &mut found })? {
            if arcs.points.len() >= MAX_POINTS {
                arcs.too_many = true;
            } else if let Item::Position(point) = item {
                arcs.points.push(point);
            }
        }
        Ok(())
    }
}

/// Lists of numbers of arcs, however deep: each is a line.
pub struct ArcNest<'a> {
    pub arcs: &'a Arcs,
    pub globe: bool,
    pub found: &'a mut Found,
}

impl<'de> DeserializeSeed<'de> for ArcNest<'_> {
    type Value = Option<i64>;

    fn deserialize<D: Deserializer<'de>>(self, from: D) -> Result<Option<i64>, D::Error> {
        from.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for ArcNest<'_> {
    type Value = Option<i64>;

    fn expecting(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        to.write_str("numbers of arcs")
    }

    fn visit_unit<E>(self) -> Result<Option<i64>, E> {
        Ok(None)
    }

    fn visit_i64<E>(self, value: i64) -> Result<Option<i64>, E> {
        Ok(Some(value))
    }

    fn visit_u64<E: Error>(self, value: u64) -> Result<Option<i64>, E> {
        Ok(i64::try_from(value).ok())
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Option<i64>, A::Error> {
        let Self { arcs, globe, found } = self;
        let (mut line, mut walk, mut last) = (Line::default(), Walk::default(), None);
        while let Some(number) = seq.next_element_seed(ArcNest { arcs, globe, found: &mut *found })? {
            let Some((points, back)) = number.and_then(|number| arcs.arc(number)) else { continue };
            arcs.used.set(arcs.used.get() + points.len());
            if arcs.used.get() > MAX_USED {
                return Err(A::Error::custom("its objects have too many points"));
            }
            let mut push = |p: DVec2| {
                // Each arc begins where the one before it ends.
                if last.replace(p) != Some(p) {
                    found.evidence.take(p);
                    line.push(walk.step(p, globe));
                }
            };
            if back {
                points.iter().rev().for_each(|&p| push(p));
            } else {
                points.iter().for_each(|&p| push(p));
            }
        }
        found.take(&line, walk.returns());
        Ok(None)
    }
}
