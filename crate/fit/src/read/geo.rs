//! GeoJSON: rings and lines on the globe.

mod visit;

use glam::DVec2;
use serde::de::DeserializeSeed;

use self::visit::{Found, Label, Nest, Object};
use super::content::FileContent;
use super::problem::ReadError;
use super::text::short;

/// The rings and lines of a text of GeoJSON; of a bare list of positions, that.
pub fn read_geo(text: &str) -> Result<FileContent, ReadError> {
    let mut found = find(text, true)?;
    if found.degrees {
        flatten_globe(&mut found);
    } else {
        found = find(text, false)?;
    }
    let word = |label: &Label| match label.closed {
        _ if is_list(text) => "list",
        true => "ring",
        false => "line",
    };
    found.gathered.finish("geojson", Vec::new(), |label| {
        format!("{} {}", label.name.as_deref().unwrap_or(word(label)), label.index + 1)
    })
}

fn is_list(text: &str) -> bool {
    text.trim_start().starts_with('[')
}

/// Finds all lines, on a globe or on a plane.
fn find(text: &str, globe: bool) -> Result<Found, ReadError> {
    let mut from = serde_json::Deserializer::from_str(text);
    let found = if is_list(text) {
        let mut found = Found::default();
        Nest { globe, found: &mut found }.deserialize(&mut from).map(|_| found)
    } else {
        Object { globe }.deserialize(&mut from)
    };
    found
        .and_then(|found| from.end().map(|()| found))
        .map_err(|error| ReadError::Broken { format: "JSON", why: short(&error.to_string(), 120) })
}

/// Degrees become lengths of one scale: those of longitude shrink with the cosine of the middle latitude.
fn flatten_globe(found: &mut Found) {
    let (low, high) = found.latitudes;
    let factor = (0.5 * (low + high)).to_radians().cos().max(0.01);
    found.gathered.change(|p| DVec2::new(factor * p.x, p.y));
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::read::NamedOutline;

    fn outlines(text: &str) -> Vec<NamedOutline> {
        let content = read_geo(text).expect("GeoJSON");
        let FileContent::Outlines { outlines, .. } = content else { panic!("outlines") };
        outlines
    }

    /// Names and how many points, by name.
    fn told(text: &str) -> Vec<(String, usize)> {
        let mut told: Vec<_> =
            outlines(text).iter().map(|one| (one.name.clone(), one.outline.points().len())).collect();
        told.sort();
        told
    }

    #[test]
    fn rings_and_lines_are_found_at_any_depth() {
        let text = r#"{"type": "FeatureCollection", "bbox": [0, 0, 1, 1], "features": [
            {"type": "Feature", "properties": {"name": "Isle", "n": [1, {"a": null}]}, "geometry": {"type": "MultiPolygon",
             "coordinates": [[[[0, 60], [2, 60, 5], [2, 61], [0, 61], [0, 60]], [[1, 60.2], [1, 60.4], [1.2, 60.4], [1.2, 60.2]]]]}},
            {"type": "Feature", "properties": null, "geometry": {"type": "GeometryCollection", "geometries": [
             {"type": "LineString", "coordinates": [[179, 59], [-179, 59], [-178, 60], [-179, 61]]}, {"type": "Point", "coordinates": [1, 2]}]}},
            {"type": "Feature", "geometry": null}]}"#;
        let wanted =
            [("Isle 1", 4), ("Isle 2", 4), ("line 3", 4)].map(|(name, count)| (name.to_string(), count));
        assert_eq!(told(text), wanted);
        // At 60 degrees a degree of longitude is half as long.
        let all = outlines(text);
        let bounds = |name: &str| all.iter().find(|one| one.name == name).expect(name).outline.bounds();
        let half = 60.0_f64.to_radians().cos();
        assert!((bounds("Isle 1").1.x - 2.0 * half).abs() < 1e-12);
        // Over the date line, and not all the way round.
        assert!((bounds("line 3").1.x - 182.0 * half).abs() < 1e-12);
    }

    #[test]
    fn the_order_in_an_object_does_not_matter() {
        let ring = "[[[0, 0], [2000, 0], [2000, 1000], [0, 1000]]]";
        for text in [
            format!(r#"{{"type": "Polygon", "coordinates": {ring}}}"#),
            format!(r#"{{"coordinates": {ring}, "type": "Polygon"}}"#),
        ] {
            assert_eq!(told(&text), [("ring 1".to_string(), 4)]);
            let feature = format!(
                r#"{{"geometry": {{"geometries": [{text}]}}, "properties": {{"NAME": "a", "name": 7}}, "id": "b"}}"#
            );
            assert_eq!(told(&feature), [("a 1".to_string(), 4)]);
        }
        // What turns out to be no line is forgotten, and with it where it lay.
        let text = r#"{"features": [{"coordinates": [[9e9, 0]], "type": "MultiPoint"},
            {"type": "LineString", "coordinates": [[0, 60], [2, 60], [2, 60.5], [0, 60.5]]}, {}, null]}"#;
        assert_eq!(told(text), [("line 1".to_string(), 4)]);
        assert!(outlines(text)[0].outline.bounds().1.x < 1.1);
    }

    #[test]
    fn what_is_in_metres_stays() {
        let text =
            r#"{"type": "Polygon", "coordinates": [[[1000, 2000], [3000, 2000], [3000, 9000], [0, 8000]]]}"#;
        assert_eq!(outlines(text)[0].outline.points()[2], DVec2::new(3000.0, 9000.0));
        // Nor does it jump as if there were a date line.
        let text = "[[0, 0], [1000, 0], [1000, 50], [400, 900], [0, 50]]";
        assert_eq!(outlines(text)[0].outline.points()[1], DVec2::new(1000.0, 0.0));
        assert_eq!(told("[[1, 2], [3, 4], [5, 0], [2, 1]]"), [("list 1".to_string(), 4)]);
    }

    #[test]
    fn coordinates_keep_every_digit() {
        let number = |k: u32| 1e3 + f64::from(frond_core::hash::counter(1, k)) / 4_294_967_295.0;
        let points: Vec<DVec2> = (0..2000).map(|k| DVec2::new(number(2 * k), number(2 * k + 1))).collect();
        let text: Vec<String> = points.iter().map(|p| format!("[{}, {}]", p.x, p.y)).collect();
        // Outlines are counter-clockwise: it may have been turned round.
        let mut found = outlines(&format!("[{}]", text.join(", ")))[0].outline.points().to_vec();
        if found[0] != points[0] {
            found.reverse();
        }
        assert_eq!(found, points);
    }

    #[test]
    fn broken_and_empty_ones_are_told_apart() {
        let code = |text: &str| read_geo(text).map(|_| ()).map_err(|error| error.code());
        for text in [
            "{",
            "{\"type\": \"Polygon\", \"coordinates\": [[[0,0]",
            "{\"coordinates\": \"x\"}",
            "{\"features\": \"x\"}",
            "{} {}",
        ] {
            assert_eq!(code(text), Err("broken"), "{text}");
        }
        for text in ["{}", "[]", "[{}]", "{\"type\": \"Topology\", \"arcs\": [[1]]}", "[[null, 1]]"] {
            assert!(matches!(code(text), Err("nothing" | "broken")), "{text}: {:?}", code(text));
        }
        assert_eq!(code(&"[".repeat(100_000)), Err("broken"));
        assert_eq!(code(&format!("{{\"features\": {}", "[{\"features\": ".repeat(50_000))), Err("broken"));
        assert_eq!(code(&format!("{{\"geometry\": {}", "{\"geometry\": ".repeat(50_000))), Err("broken"));
        assert_eq!(code(&format!("{{\"x\": {}", "[".repeat(1_000_000))), Err("broken"));
    }
}
