//! JSON as other programs write it: on the globe, on a plane, and on pictures.

use frond_fit::{FileContent, ReadAs, ReadError, read_file};
use glam::DVec2;

type Corners = (DVec2, DVec2);

fn try_read(text: &str) -> Result<(Vec<(String, Corners)>, String), ReadError> {
    match read_file(text.as_bytes(), ReadAs::Guess)? {
        FileContent::Outlines { outlines, remarks, .. } => {
            let named = outlines.iter().map(|one| (one.name.clone(), one.outline.bounds())).collect();
            Ok((named, remarks.into_iter().map(|remark| remark.message).collect::<Vec<_>>().join(" ")))
        }
        FileContent::Series { .. } => panic!("a series: {text}"),
    }
}

/// Names and boxes of outlines, and what is said.
#[track_caller]
fn read(text: &str) -> (Vec<(String, Corners)>, String) {
    try_read(text).unwrap_or_else(|error| panic!("{error}: {text}"))
}

fn corners(low: [f64; 2], high: [f64; 2]) -> Corners {
    (DVec2::from(low), DVec2::from(high))
}

#[track_caller]
fn is_near((low, high): Corners, wanted: Corners) {
    assert!(low.distance(wanted.0) + high.distance(wanted.1) < 1e-6, "{low} {high}, not {wanted:?}");
}

fn polygon(points: &[[f64; 2]]) -> String {
    format!(r#"{{"type": "Polygon", "coordinates": [{}]}}"#, ring(points))
}

fn ring(points: &[[f64; 2]]) -> String {
    format!("{points:?}")
}

fn square(low: [f64; 2], size: f64) -> Vec<[f64; 2]> {
    let [x, y] = low;
    vec![[x, y], [x + size, y], [x + size, y + size], [x, y + size], [x, y]]
}

fn collection(crs: &str, properties: &str, geometry: &str) -> String {
    format!(
        r#"{{"type": "FeatureCollection", {crs} "features": [{{"type": "Feature", "properties": {properties}, "geometry": {geometry}}}]}}"#
    )
}

fn crs(name: &str) -> String {
    format!(r#""crs": {{"type": "name", "properties": {{"name": "{name}"}}}},"#)
}

#[test]
fn a_square_in_pixels_or_millimetres_stays_a_square() {
    let sixty = square([0.0, 0.0], 60.0);
    let far = square([10.1234, 50.4321], 9.0);
    for (text, points) in [
        (polygon(&sixty), &sixty),
        (ring(&sixty), &sixty),
        (ring(&far), &far),
        (collection("", "{}", &polygon(&sixty)), &sixty),
        (collection("", r#"{"classification": "road", "kind": "shapes"}"#, &polygon(&sixty)), &sixty),
        (
            collection(r#""crs": {"type": "EPSG", "properties": {"code": 28992}},"#, "{}", &polygon(&far)),
            &far,
        ),
        (collection(&crs("urn:ogc:def:crs:EPSG::28992"), "{}", &polygon(&far)), &far),
        (
            format!(
                "{}{}",
                collection("", "{}", &polygon(&far)).strip_suffix('}').expect("an object"),
                r#", "crs": {"type": "name", "properties": {"name": "EPSG:3857"}}}"#
            ),
            &far,
        ),
    ] {
        let (found, _) = read(&text);
        is_near(found[0].1, (DVec2::from(points[0]), DVec2::from(points[2])));
    }
    // What was assumed is said where it counts: half way up, at 30 degrees, the cosine is 0.866.
    assert!(
        read(&polygon(&sixty)).1.contains("pixels or millimetres")
            && read(&polygon(&sixty)).1.contains("87 %")
    );
    assert_eq!(read(&collection(&crs("EPSG:28992"), "{}", &polygon(&far))).1, "");
    assert_eq!(read(&ring(&sixty)).1, "");
}

#[test]
fn degrees_shrink_and_it_is_said() {
    // One degree high, from 59.5 to 60.5: at 60 degrees widths are half.
    let far = square([10.1234, 59.5], 1.0);
    let wanted = corners([0.5 * 10.1234, 59.5], [0.5 * 11.1234, 60.5]);
    for text in [
        polygon(&far),
        collection("", "null", &polygon(&far)),
        collection(&crs("urn:ogc:def:crs:OGC:1.3:CRS84"), "{}", &polygon(&far)),
        format!("[{}]", collection("", "{}", &polygon(&far))),
        format!(r#"{{"type": "GeometryCollection", "geometries": [{}]}}"#, polygon(&far)),
    ] {
        let (found, said) = read(&text);
        is_near(found[0].1, wanted);
        assert!(said.contains("widths shrink to 50 %"), "{said}");
    }
    let (found, _) = read(
        r#"[{"lat": 59.5, "lng": 10}, {"lat": 59.5, "lng": 12}, {"lat": 60.5, "lng": 12}, {"lat": 60.5, "lng": 10}]"#,
    );
    is_near(found[0].1, corners([5.0, 59.5], [6.0, 60.5]));
    // The file says so, however its numbers look.
    let (found, _) = read(&collection(&crs("EPSG:4326"), "{}", &polygon(&square([0.0, 0.0], 60.0))));
    is_near(found[0].1, corners([0.0, 0.0], [60.0 * 30.0_f64.to_radians().cos(), 60.0]));
}

#[test]
fn what_is_drawn_on_a_picture_is_upright() {
    let points = "[[1, 2], [5, 2], [5, 9], [3, 9.5]]";
    let flat = "[1, 2, 5, 2, 5, 9, 3, 9.5]";
    let geometry = polygon(&[[1.0, 2.0], [5.0, 2.0], [5.0, 9.0], [3.0, 9.5], [1.0, 2.0]]);
    let via = r#"{"shape_attributes": {"name": "polygon", "all_points_x": [1, 5, 5, 3], "all_points_y": [2, 2, 9, 9.5]}, "region_attributes": {"kind": "oak"}}"#;
    for (text, name) in [
        (format!(r#"[{{"type": "Feature", "id": "a", "geometry": {geometry}, "properties": {{"classification": {{"name": "oak"}}, "isLocked": false}}}}]"#), "oak 1"),
        (collection("", r#"{"objectType": "annotation"}"#, &geometry), "ring 1"),
        (format!(r#"{{"images": [{{"id": 1, "width": 9}}], "annotations": [{{"id": 1, "category_id": 4, "segmentation": [{flat}], "bbox": [1, 2, 4, 7.5], "iscrowd": 0}}], "categories": [{{"id": 3, "name": "elm"}}, {{"id": 4, "name": "oak"}}]}}"#), "oak 1"),
        (format!(r#"{{"version": "5.0", "flags": {{}}, "shapes": [{{"label": "oak", "points": {points}, "shape_type": "polygon"}}, {{"label": "box", "points": [[0, 0], [99, 99]], "shape_type": "rectangle"}}], "imageData": "AAAA"}}"#), "oak 1"),
        (format!(r#"{{"_via_settings": {{}}, "_via_img_metadata": {{"a.jpg9": {{"filename": "a.jpg", "regions": [{via}]}}}}}}"#), "oak 1"),
        (format!(r#"{{"a.jpg9": {{"filename": "a.jpg", "regions": {{"0": {via}}}}}}}"#), "oak 1"),
        (r#"[{"id": 1, "data": {"image": "a.jpg"}, "annotations": [{"result": [{"original_width": 200, "original_height": 50, "type": "polygonlabels", "value": {"points": [[0.5, 4], [2.5, 4], [2.5, 18], [1.5, 19]], "polygonlabels": ["oak"]}}]}]}]"#.to_string(), "oak 1"),
        (format!(r#"{{"size": {{"height": 9}}, "objects": [{{"classTitle": "oak", "geometryType": "polygon", "points": {{"exterior": {points}, "interior": []}}}}]}}"#), "oak 1"),
        (r#"{"item": {}, "annotations": [{"name": "oak", "polygon": {"paths": [[{"x": 1, "y": 2}, {"x": 5, "y": 2}, {"x": 5, "y": 9}, {"x": 3, "y": 9.5}]]}}]}"#.to_string(), "oak 1"),
    ] {
        let (found, said) = read(&text);
        assert_eq!(found.len(), 1, "{text}");
        assert_eq!(found[0].0, name, "{text}");
        is_near(found[0].1, corners([1.0, -9.5], [5.0, -2.0]));
        assert!(said.contains("turned upright"), "{said}: {text}");
        assert_eq!(said.contains("Left out: 1 boxes"), text.contains("rectangle"), "{said}: {text}");
    }
}

#[test]
fn points_may_be_objects_and_lists_of_x_and_y() {
    for text in [
        r#"[{"x": 1, "y": 2}, {"x": 5, "y": 2}, {"x": 5, "y": 9}, {"x": 3, "y": 9.5}]"#,
        r#"{"x": [1, 5, 5, 3], "y": [2, 2, 9, 9.5]}"#,
        r#"{"x": {"0": 1, "1": 5, "2": 5, "3": 3}, "y": {"0": 2, "1": 2, "2": 9, "3": 9.5}}"#,
        r#"{"name": "a", "points": [[1, 2], [5, 2], [5, 9], [3, 9.5]]}"#,
        "# by hand\n[[1, 2], [5, 2], [5, 9], [3, 9.5]]",
        "[1, 2],\n[5, 2],\n[5, 9],\n[3, 9.5]\n",
    ] {
        let (found, said) = read(text);
        is_near(found[0].1, corners([1.0, 2.0], [5.0, 9.5]));
        assert!(!said.contains("upright"), "{said}");
    }
}

#[test]
fn topologies_are_read() {
    let file = |arcs: &str, geometry: &str, transform: &str| {
        format!(r#"{{"type": "Topology", "objects": {{"isles": {geometry}}}, "arcs": {arcs}{transform}}}"#)
    };
    // Two squares side by side share an arc, which the second has backwards.
    let arcs = "[[[1000, 0], [1000, 1000]], [[1000, 1000], [0, 1000], [0, 0], [1000, 0]], [[1000, 1000], [2000, 1000], [2000, 0], [1000, 0]]]";
    let both = r#"{"type": "GeometryCollection", "geometries": [{"type": "Polygon", "arcs": [[0, 1]], "properties": {"name": "west"}},
        {"type": "MultiPolygon", "arcs": [[[-1, 2]]], "id": "east"}]}"#;
    let (mut found, said) = read(&file(arcs, both, ""));
    found.sort_by(|a, b| b.0.cmp(&a.0));
    assert_eq!(found[0], ("west 1".into(), corners([0.0, 0.0], [1000.0, 1000.0])));
    // Backwards along the shared side, then round the east.
    assert_eq!(found[1], ("east 2".into(), corners([1000.0, 0.0], [2000.0, 1000.0])));
    assert_eq!(said, "");
    // Differences of whole numbers, with a scale: one degree and a half on one at latitude 50.
    let arcs = "[[[0, 0], [9999, 0], [0, 5000], [-4000, 4999], [-5999, 0], [0, -9999]]]";
    let transform = r#", "transform": {"scale": [0.0001, 0.0001], "translate": [10, 50]}"#;
    let (found, said) = read(&file(arcs, r#"{"type": "Polygon", "arcs": [[0]]}"#, transform));
    let shrunk = 50.49995_f64.to_radians().cos();
    assert_eq!(found[0].0, "isles 1");
    is_near(found[0].1, corners([10.0 * shrunk, 50.0], [10.9999 * shrunk, 50.9999]));
    assert!(said.contains("64 %"), "{said}");
    // Numbers of arcs that are not there, and none at all.
    for geometry in [r#"{"type": "Polygon", "arcs": [[7, -9, 1e300]]}"#, "null", "{}"] {
        assert!(try_read(&file(arcs, geometry, "")).is_err());
    }
}

#[test]
fn what_is_no_outline_is_named() {
    for (text, said) in [
        (
            "[[0, 0, 0, 0.16, 0, 0, 0.01], [0.85, 0.04, -0.04, 0.85, 0, 1.6, 0.85], [1, 2, 3, 4, 5, 6, 7], [2, 1, 3, 4, 5, 6, 7]]",
            "open it in Morph",
        ),
        (r#"{"transforms": [{"a": 1, "b": 2, "c": 3, "d": 4, "e": 5, "f": 6}]}"#, "open it in Morph"),
        (
            r#"{"images": [], "annotations": [{"segmentation": {"counts": [1, 2, 3], "size": [3, 4]}}]}"#,
            "Export polygons",
        ),
        (
            r#"{"shapes": [{"label": "a", "points": [[1, 2], [3, 4]], "shape_type": "circle"}]}"#,
            "no polygons",
        ),
        (
            r#"{"type": "MultiPoint", "coordinates": [[1, 2], [5, 2], [5, 9], [3, 9]]}"#,
            "GeoJSON and TopoJSON",
        ),
        (r#"{"version": 1, "name": "package"}"#, "GeoJSON and TopoJSON"),
    ] {
        let error = try_read(text).expect_err(text).to_string();
        assert!(error.contains(said), "{error}: {text}");
    }
}
