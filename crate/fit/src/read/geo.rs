//! GeoJSON: rings and lines on the globe.

use std::fmt;

use glam::DVec2;
use serde::de::{Deserialize, Deserializer, IgnoredAny, SeqAccess, Visitor};
use serde_json::Value;

use super::problem::ReadError;
use super::{Raw, text::short};

/// More points than this are not kept.
const KEPT: usize = 1 << 21;

/// Any object of GeoJSON, as much of it as counts.
#[derive(serde::Deserialize)]
struct Object {
    #[serde(rename = "type")]
    kind: Option<String>,
    #[serde(default)]
    coordinates: Nest,
    #[serde(default)]
    features: Vec<Object>,
    #[serde(default)]
    geometries: Vec<Object>,
    geometry: Option<Box<Object>>,
    id: Option<Value>,
    properties: Option<Properties>,
}

#[derive(serde::Deserialize)]
struct Properties {
    #[serde(alias = "NAME", alias = "Name")]
    name: Option<Value>,
}

/// Coordinates: lists of lists of positions, however deep.
#[derive(Default)]
enum Nest {
    #[default]
    None,
    Number(f64),
    Position(DVec2),
    List(Vec<Nest>),
}

impl<'de> Deserialize<'de> for Nest {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        from.deserialize_any(NestVisitor)
    }
}

struct NestVisitor;

impl<'de> Visitor<'de> for NestVisitor {
    type Value = Nest;

    fn expecting(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        to.write_str("coordinates")
    }

    fn visit_f64<E>(self, value: f64) -> Result<Nest, E> {
        Ok(Nest::Number(value))
    }

    fn visit_i64<E>(self, value: i64) -> Result<Nest, E> {
        Ok(Nest::Number(value as f64))
    }

    fn visit_u64<E>(self, value: u64) -> Result<Nest, E> {
        Ok(Nest::Number(value as f64))
    }

    fn visit_unit<E>(self) -> Result<Nest, E> {
        Ok(Nest::None)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Nest, A::Error> {
        let mut list = Vec::new();
        match seq.next_element::<Nest>()? {
            None => return Ok(Nest::List(list)),
            Some(Nest::Number(x)) => {
                // A position: what comes after its second number is height and time.
                let y = seq.next_element::<Nest>()?;
                while seq.next_element::<IgnoredAny>()?.is_some() {}
                return Ok(match y {
                    Some(Nest::Number(y)) if x.abs() <= 1e100 && y.abs() <= 1e100 => {
                        Nest::Position(DVec2::new(x, y))
                    }
                    _ => Nest::None,
                });
            }
            Some(first) => list.push(first),
        }
        while let Some(next) = seq.next_element::<Nest>()? {
            list.push(next);
        }
        Ok(Nest::List(list))
    }
}

/// The rings and lines of a text of GeoJSON; of a bare list of positions, that.
pub fn read_geo(text: &str) -> Result<Vec<Raw>, ReadError> {
    let broken =
        |error: serde_json::Error| ReadError::Broken { format: "JSON", why: short(&error.to_string(), 120) };
    let mut found = Found::default();
    if text.trim_start().starts_with('[') {
        let nest: Nest = serde_json::from_str(text).map_err(broken)?;
        found.lines(&nest, "list", false);
    } else {
        let object: Object = serde_json::from_str(text).map_err(broken)?;
        found.object(&object, None);
    }
    if found.raws.is_empty() {
        return Err(ReadError::Nothing { format: "JSON" });
    }
    flatten_globe(&mut found.raws);
    Ok(found.raws)
}

#[derive(Default)]
struct Found {
    raws: Vec<Raw>,
    points: usize,
}

impl Found {
    fn object(&mut self, object: &Object, name: Option<&str>) {
        let own =
            object.properties.as_ref().and_then(|properties| properties.name.as_ref()).or(object.id.as_ref());
        let own = own.map(|value| value.as_str().map_or_else(|| value.to_string(), Into::into));
        let name = own.as_deref().or(name);
        for inner in object.features.iter().chain(&object.geometries).chain(object.geometry.as_deref()) {
            self.object(inner, name);
        }
        let kind = object.kind.as_deref().unwrap_or_default();
        let closed = matches!(kind, "Polygon" | "MultiPolygon");
        if closed || matches!(kind, "LineString" | "MultiLineString") {
            let word = if closed { "ring" } else { "line" };
            self.lines(&object.coordinates, name.unwrap_or(word), closed);
        }
    }

    /// Takes each list of positions.
    fn lines(&mut self, nest: &Nest, name: &str, closed: bool) {
        let Nest::List(list) = nest else { return };
        let position = |nest: &Nest| if let Nest::Position(point) = nest { Some(*point) } else { None };
        let points: Vec<DVec2> =
            list.iter().filter_map(position).take(KEPT.saturating_sub(self.points)).collect();
        self.points += points.len();
        if !points.is_empty() {
            let name = format!("{} {}", short(name, 40), self.raws.len() + 1);
            self.raws.push(Raw {
                name,
                closed: closed || points.first() == points.last(),
                points,
                ground: false,
            });
        }
        for inner in list {
            self.lines(inner, name, closed);
        }
    }
}

/// Degrees become lengths of one scale: those of longitude shrink with the cosine of the middle latitude.
fn flatten_globe(raws: &mut [Raw]) {
    let degrees = |p: &DVec2| p.x.abs() <= 360.0 && p.y.abs() <= 90.0;
    if !raws.iter().flat_map(|raw| &raw.points).all(degrees) {
        return;
    }
    for raw in raws.iter_mut() {
        // Across the date line the numbers jump, the coast does not.
        for i in 1..raw.points.len() {
            let turns = ((raw.points[i].x - raw.points[i - 1].x) / 360.0).round();
            raw.points[i].x -= 360.0 * turns;
        }
    }
    let all = || raws.iter().flat_map(|raw| &raw.points).map(|p| p.y);
    let (low, high) = (all().fold(f64::INFINITY, f64::min), all().fold(f64::NEG_INFINITY, f64::max));
    let factor = (0.5 * (low + high)).to_radians().cos().max(0.01);
    raws.iter_mut().flat_map(|raw| &mut raw.points).for_each(|p| p.x *= factor);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rings_and_lines_are_found_at_any_depth() {
        let text = r#"{"type": "FeatureCollection", "bbox": [0, 0, 1, 1], "features": [
            {"type": "Feature", "properties": {"name": "Isle", "n": [1, {"a": null}]}, "geometry": {"type": "MultiPolygon",
             "coordinates": [[[[0, 60], [2, 60, 5], [2, 61], [0, 61], [0, 60]], [[1, 60.2], [1, 60.4], [1.2, 60.4], [1, 60.2]]]]}},
            {"type": "Feature", "properties": null, "geometry": {"type": "GeometryCollection", "geometries": [
             {"type": "LineString", "coordinates": [[179, 59], [-179, 59], [-178, 60]]}, {"type": "Point", "coordinates": [1, 2]}]}},
            {"type": "Feature", "geometry": null}]}"#;
        let raws = read_geo(text).expect("GeoJSON");
        let told: Vec<_> = raws.iter().map(|raw| (raw.name.as_str(), raw.points.len(), raw.closed)).collect();
        assert_eq!(told, [("Isle 1", 5, true), ("Isle 2", 4, true), ("line 3", 3, false)]);
        // At 60 degrees a degree of longitude is half as long.
        let half = 60.0_f64.to_radians().cos();
        assert!((raws[0].points[1].x - 2.0 * half).abs() < 1e-12);
        assert!((raws[2].points[1].x - 181.0 * half).abs() < 1e-12);
    }

    #[test]
    fn what_is_in_metres_stays() {
        let text = r#"{"type": "Polygon", "coordinates": [[[1000, 2000], [3000, 2000], [3000, 9000]]]}"#;
        assert_eq!(read_geo(text).expect("GeoJSON")[0].points[2], DVec2::new(3000.0, 9000.0));
        assert_eq!(read_geo("[[1, 2], [3, 4], [5, 0]]").expect("a list")[0].points.len(), 3);
    }

    #[test]
    fn coordinates_keep_every_digit() {
        let number = |k: u32| 1e3 + f64::from(frond_core::hash::counter(1, k)) / 4_294_967_295.0;
        let points: Vec<DVec2> = (0..2000).map(|k| DVec2::new(number(2 * k), number(2 * k + 1))).collect();
        let text: Vec<String> = points.iter().map(|p| format!("[{}, {}]", p.x, p.y)).collect();
        assert_eq!(read_geo(&format!("[{}]", text.join(", "))).expect("a list")[0].points, points);
    }

    #[test]
    fn broken_and_empty_ones_are_told_apart() {
        for text in ["{", "{\"type\": \"Polygon\", \"coordinates\": [[[0,0]", "{\"coordinates\": \"x\"}"] {
            assert_eq!(read_geo(text).map(|_| ()).map_err(|e| e.code()), Err("broken"), "{text}");
        }
        for text in ["{}", "[]", "[{}]", "{\"type\": \"Topology\", \"arcs\": [[1]]}", "[[null, 1]]"] {
            let code = read_geo(text).map(|_| ()).map_err(|e| e.code());
            assert!(matches!(code, Err("nothing" | "broken")), "{text}: {code:?}");
        }
        let deep = "[".repeat(100_000);
        assert_eq!(read_geo(&deep).map(|_| ()).map_err(|e| e.code()), Err("broken"));
        let deep = format!("{{\"features\": {}", "[{\"features\": ".repeat(50_000));
        assert_eq!(read_geo(&deep).map(|_| ()).map_err(|e| e.code()), Err("broken"));
    }
}
