//! JSON: rings and lines of GeoJSON and TopoJSON, on the globe or on a plane, and outlines that were drawn on pictures.

mod annotation;
mod evidence;
mod found;
mod nest;
mod topology;
mod visit;
mod word;

use glam::DVec2;
use serde::de::DeserializeSeed;

use self::annotation::{Known, Node};
use self::evidence::Units;
use self::found::{Found, Label};
use self::nest::Nest;
use self::topology::{Arcs, arcs};
use self::visit::{Object, Objects};
use super::content::FileContent;
use super::problem::{ReadError, Remark};
use super::text::short;

/// What the first keys of a text say that it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    /// An object of GeoJSON or TopoJSON.
    Object,
    /// A list of objects of GeoJSON.
    Objects,
    /// A list of positions.
    List,
    /// Outlines drawn on pictures.
    Pictures,
    /// An object of another kind, which may have lists of points.
    Other,
}

/// A factor that is nearer to 1 changes no shape that is seen.
const UNSEEN: f64 = 0.005;

/// The outlines of JSON; of a bare list of positions, that.
pub fn read_geo(text: &str) -> Result<FileContent, ReadError> {
    let kind = kind(text);
    if matches!(kind, Kind::Pictures | Kind::Other) {
        return pictures(text, kind == Kind::Pictures);
    }
    let topology = if kind == Kind::Object { arcs(text)? } else { None };
    let mut found = find(text, kind, topology.as_ref(), true)?;
    let (units, factor) = (found.evidence.units(kind == Kind::List), found.evidence.factor());
    if units != Units::Degrees {
        found = find(text, kind, topology.as_ref(), false)?;
    }
    let mut remarks = Vec::new();
    let mut say = |message: String| remarks.push(Remark::new("assumed", message));
    let percent = (100.0 * factor).round();
    match units {
        // Degrees become lengths of one scale: those of longitude shrink with the cosine of the middle latitude.
        Units::Degrees => {
            found.gathered.change(|p| DVec2::new(factor * p.x, p.y));
            if 1.0 - factor > UNSEEN {
                say(format!(
                    "The numbers are taken for longitudes and latitudes, so that widths shrink to {percent} %. If they \
                     are pixels or millimetres, save them as a table of x and y (CSV)."
                ));
            }
        }
        Units::Guessed if 1.0 - factor > UNSEEN && found.count > 0 => say(format!(
            "The numbers are taken for pixels or millimetres and stay as they are. If they are longitudes and \
             latitudes, widths should shrink to {percent} %: give the file a crs that says so."
        )),
        Units::Pixels => {
            found.gathered.mirror();
            say(UPRIGHT.into());
        }
        Units::Guessed | Units::Lengths => {}
    }
    let long = found.evidence.long;
    let word = |label: &Label| match label.closed {
        _ if kind == Kind::List => "list",
        true => "ring",
        false => "line",
    };
    let read = found.gathered.finish("geojson", remarks, |label| {
        format!(
            "{} {}",
            label.name.as_deref().map_or_else(|| word(label).into(), |name| short(name, 40)),
            label.index + 1
        )
    });
    read.map_err(|error| if long { nothing(text, true, error) } else { error })
}

const UPRIGHT: &str = "In pictures y goes down: the outlines are turned upright, as they are seen there.";

/// Rows of more numbers than positions have, or objects with their letters, are maps.
fn nothing(text: &str, long: bool, error: ReadError) -> ReadError {
    let letters = || ["\"a\"", "\"b\"", "\"e\"", "\"f\""].iter().all(|key| text.contains(key));
    let maps = long || letters() || text.contains("\"maps\"") || text.contains("\"transformations\"");
    match error {
        ReadError::Nothing { format: "JSON" } if maps => ReadError::Nothing { format: "maps" },
        error => error,
    }
}

/// Outlines drawn on pictures, where `upright` is to be made what has y downwards; or other lists of points.
fn pictures(text: &str, upright: bool) -> Result<FileContent, ReadError> {
    let (mut found, mut known) = (Found::default(), Known::default());
    let mut from = serde_json::Deserializer::from_str(text);
    // Older files of VIA have names of pictures for keys.
    let named = upright && !text.contains("\"_via_img_metadata\"") && text.contains("\"shape_attributes\"");
    let node = Node { found: &mut found, known: &mut known, points: text.starts_with('['), named };
    node.deserialize(&mut from).and_then(|_| from.end()).map_err(|error| broken(&error))?;
    let mut remarks = Vec::new();
    if upright {
        found.gathered.mirror();
        remarks.push(Remark::new("assumed", UPRIGHT));
    }
    for (count, what) in [(known.others, "boxes, circles and points"), (known.masks, "masks of pixels")] {
        if count > 0 {
            let message = format!("Left out: {count} {what}. Only polygons and lines are read.");
            remarks.push(Remark::new("ignored", message));
        }
    }
    let (masks, others) = (known.masks, known.others);
    let read = found.gathered.finish("geojson", remarks, |label| {
        let class = label.class.and_then(|class| known.classes.iter().find(|(id, _)| *id == class));
        let name = label.name.as_deref().or(class.map(|(_, name)| name.as_str())).unwrap_or("outline");
        format!("{} {}", short(name, 40), label.index + 1)
    });
    read.map_err(|error| match error {
        ReadError::Nothing { .. } if masks > 0 => ReadError::Nothing { format: "masks" },
        ReadError::Nothing { .. } if others > 0 => ReadError::Nothing { format: "boxes" },
        error => nothing(text, false, error),
    })
}

fn broken(error: &serde_json::Error) -> ReadError {
    ReadError::Broken { format: "JSON", why: short(&error.to_string(), 120) }
}

/// What the text is, by the keys that its beginning has.
fn kind(text: &str) -> Kind {
    let text = text.trim_start();
    let list = text.strip_prefix('[').map(str::trim_start);
    if list.is_some_and(|inside| !inside.starts_with('{')) {
        return Kind::List;
    }
    let has = |key: &str| text.contains(&format!("\"{key}\""));
    let geo = ["coordinates", "features", "geometry", "geometries", "Topology"].iter().any(|key| has(key));
    // Names of shapes may be any words; those of the types of GeoJSON are in no other file.
    let surely =
        ["FeatureCollection", "Feature", "Topology", "GeometryCollection"].iter().any(|key| has(key));
    let drawn = !surely
        && (["segmentation", "shapes", "shape_attributes", "polygonlabels", "classTitle"]
            .iter()
            .any(|key| has(key))
            || (has("annotations") && ["images", "result", "item", "polygon"].iter().any(|key| has(key))));
    match list {
        _ if drawn => Kind::Pictures,
        Some(_) if geo => Kind::Objects,
        Some(_) => Kind::List,
        None if geo => Kind::Object,
        None => Kind::Other,
    }
}

/// Finds all lines, on a globe or on a plane.
fn find(text: &str, kind: Kind, arcs: Option<&Arcs>, globe: bool) -> Result<Found, ReadError> {
    let mut from = serde_json::Deserializer::from_str(text);
    let mut found = Found::default();
    let object = Object { globe, arcs };
    if let Some(arcs) = arcs {
        arcs.used.set(0);
    }
    let read = match kind {
        Kind::List => Nest { globe, found: &mut found }.deserialize(&mut from).map(|_| ()),
        Kind::Objects => Objects { of: object, found: &mut found }.deserialize(&mut from),
        Kind::Object | Kind::Pictures | Kind::Other => object.deserialize(&mut from).map(|all| found = all),
    };
    read.and_then(|()| from.end()).map_err(|error| broken(&error))?;
    Ok(found)
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
