//! Text files as people drop them, and worse ones.

use std::fmt::Write as _;

use frond_fit::{
    FileContent, FileKind, MAX_OUTLINE, NamedOutline, ReadAs, ReadError, maple_leaf, read_file, sniff,
};
use glam::DVec2;
use proptest::prelude::*;

fn outlines(text: &str) -> Vec<NamedOutline> {
    match read_file(text.as_bytes(), ReadAs::Guess) {
        Ok(FileContent::Outlines { outlines, .. }) => outlines,
        other => panic!("no outlines: {other:?}"),
    }
}

fn codes(content: &FileContent) -> Vec<&'static str> {
    let (FileContent::Outlines { remarks, .. } | FileContent::Series { remarks, .. }) = content;
    assert!(remarks.iter().all(|remark| remark.message.len() > 15));
    remarks.iter().map(|remark| remark.code).collect()
}

fn code(bytes: &[u8]) -> &'static str {
    match read_file(bytes, ReadAs::Guess) {
        Ok(content) => panic!("it was read: {:?}", codes(&content)),
        Err(error) => {
            assert!(error.to_string().len() > 25, "{error}");
            error.code()
        }
    }
}

fn svg(inside: &str) -> String {
    format!(
        "<?xml version=\"1.0\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" \
         viewBox=\"0 0 100 80\">{inside}</svg>"
    )
}

#[test]
fn shapes_of_all_kinds_have_their_areas() {
    let pi = std::f64::consts::PI;
    for (shape, area) in [
        ("<rect x='1' y='2' width='30' height='20'/>", 600.0),
        ("<rect width='30px' height='20' rx='4' ry='2'/>", 600.0 - (4.0 - pi) * 8.0),
        ("<circle cx='9' cy='9' r='5'/>", 25.0 * pi),
        ("<ellipse cx='9' cy='9' rx='5' ry='3'/>", 15.0 * pi),
        ("<polygon points='0,0 10,0 10,5 0,5'/>", 50.0),
        ("<polyline points='0 0,10 0 10 5 , 0 5'/>", 50.0),
        ("<path d='m1 1h8v6h-8z'/>", 48.0),
        ("<path d='M0 0 A 10 10 0 0 1 20 0 A 10 10 0 0 1 0 0'/>", 100.0 * pi),
        ("<path d='M0,0C0,10 10,10 10,0S20-10 20,0V30H0Z'/>", 600.0),
        ("<g transform='scale(2)'><g transform='rotate(30)'><rect width='3' height='2'/></g></g>", 24.0),
    ] {
        let found = outlines(&svg(shape));
        assert_eq!(found.len(), 1, "{shape}");
        let is = found[0].outline.area();
        assert!((is / area - 1.0).abs() < 1e-3, "{shape}: {is}, not {area}");
        assert_eq!(found[0].crossings, Some(0));
    }
}

#[test]
fn y_is_up_and_the_largest_is_first() {
    let found =
        outlines(&svg("<rect id='ground' width='100' height='80'/><rect x='1' y='1' width='4' height='4'/>
         <path id='leaf' d='M10 10 h30 v20 h-30 z M12 12 h5 v5 h-5 z'/>"));
    let names: Vec<_> = found.iter().map(|one| one.name.as_str()).collect();
    // The ground that all is drawn on comes last.
    assert_eq!(names, ["leaf, part 1 of 2", "leaf, part 2 of 2", "shape 2", "ground"]);
    assert_eq!(found[0].outline.bounds(), (DVec2::new(10.0, -30.0), DVec2::new(40.0, -10.0)));
}

#[test]
fn what_is_used_is_drawn_and_what_is_defined_is_not() {
    let inside = "<defs><rect id='r' width='10' height='5'/><symbol id='s'><circle r='2'/></symbol></defs>
        <clipPath><rect width='99' height='70'/></clipPath>
        <use href='#r' x='3'/><use xlink:href='#s' transform='scale(3)'/><rect width='9' height='9' display='none'/>
        <g style='fill: red; display : none'><rect width='9' height='9'/></g>";
    let areas: Vec<_> = outlines(&svg(inside)).iter().map(|one| one.outline.area().round()).collect();
    // What a symbol draws beyond its own corner is cut off: a quarter of the circle is left.
    assert_eq!(areas, [50.0, 28.0]);
}

#[test]
fn scripts_and_what_is_elsewhere_are_passed_over() {
    let inside = "<script>alert(1)</script><image href='http://example.org/x.png'/><text>leaf</text>
        <use href='http://example.org/a.svg#x'/><use href='#missing'/><path d='M0 0h9v9h-9z' onload='alert(2)'/>";
    let content = read_file(svg(inside).as_bytes(), ReadAs::Guess).expect("a drawing");
    assert_eq!(codes(&content), ["ignored"]);
    assert_eq!(code(svg("<script>alert(1)</script><text>leaf</text>").as_bytes()), "nothing");
}

#[test]
fn a_billion_laughs_are_refused_and_so_are_nested_uses() {
    let mut laughs = String::from("<?xml version='1.0'?><!DOCTYPE svg [<!ENTITY a0 'ha'>");
    for i in 1..10 {
        let inside = format!("&a{};", i - 1).repeat(10);
        let _ = write!(laughs, "<!ENTITY a{i} '{inside}'>");
    }
    laughs.push_str("]><svg xmlns='http://www.w3.org/2000/svg'><text>&a9;</text></svg>");
    assert_eq!(code(laughs.as_bytes()), "entities");

    let mut uses = String::from("<g id='g0'><path d='M0 0h9v9h-9z'/></g>");
    for i in 1..10 {
        let inside = format!("<use href='#g{}'/>", i - 1).repeat(10);
        let _ = write!(uses, "<g id='g{i}'>{inside}</g>");
    }
    assert_eq!(code(svg(&uses).as_bytes()), "too-many");
    // One that uses itself ends.
    let content = read_file(
        svg("<g id='g'><rect width='5' height='4'/><use href='#g' x='1'/></g>").as_bytes(),
        ReadAs::Guess,
    );
    assert!(content.is_ok_and(|content| codes(&content) == ["ignored"]));
    let wide = "<g/>".repeat(30_000);
    assert_eq!(code(svg(&wide).as_bytes()), "too-many");
    let deep = |count: usize| svg(&format!("{}{}", "<g>".repeat(count), "</g>".repeat(count)));
    assert_eq!(code(deep(150).as_bytes()), "nothing");
    assert_eq!(code(deep(15_000).as_bytes()), "too-many");
}

#[test]
fn broken_drawings_say_where() {
    assert_eq!(code(b"<svg xmlns='http://www.w3.org/2000/svg'><path d='M0 0"), "broken");
    assert_eq!(code(b"<svg><rect></svg>"), "broken");
    for d in ["", "M", "hello", "M0 0", "M0 0 L1 1", "M0 0 L 1e999 0 L 0 1e999 Z", "M0 0h1h1h1z"] {
        let got = code(svg(&format!("<path d='{d}'/>")).as_bytes());
        assert!(["nothing", "too-few-points", "flat"].contains(&got), "{d}: {got}");
    }
}

#[test]
fn tables_are_outlines_or_series() {
    let ring = "x,y\n0,0\n4,0\n4,3\n2,5\n0,3\n";
    assert_eq!(outlines(ring)[0].outline.area(), 16.0);
    let series = |text: &str| match read_file(text.as_bytes(), ReadAs::Guess) {
        Ok(FileContent::Series { points, or_outline, .. }) => (points, or_outline),
        other => panic!("no series: {other:?}"),
    };
    assert_eq!(
        series("0,5\n1,7\n2,4\n5,5\n"),
        (vec![DVec2::new(0.0, 5.0), DVec2::new(1.0, 7.0), DVec2::new(2.0, 4.0), DVec2::new(5.0, 5.0)], true)
    );
    assert_eq!(series("9;1\n8;2\n7;3\n6;4\n").0[0], DVec2::new(6.0, 4.0));
    assert_eq!(series("5\n7\n4\n").0.len(), 3);
    assert!(!series("5\n7\n4\n9\n").1);
    // The other way round when it is asked for.
    let forced = read_file(b"0,5\n1,7\n2,4\n5,5\n", ReadAs::Outlines);
    assert!(matches!(forced, Ok(FileContent::Outlines { .. })), "{forced:?}");
    let forced = read_file(ring.as_bytes(), ReadAs::Series).expect("a series");
    assert!(matches!(&forced, FileContent::Series { points, .. } if points.len() == 3));
    assert_eq!(read_file(b"5\n7\n4\n9", ReadAs::Outlines), Err(ReadError::OneColumn));
}

#[test]
fn few_and_flat_points_are_refused() {
    // A triangle is an outline.
    assert_eq!(outlines("0,0\n1,0\n0,1\n")[0].outline.area(), 0.5);
    assert_eq!(code(b"1,2\n3,4\n"), "too-few-points");
    assert_eq!(code(b"0,0\n1,1\n0,0\n2,2\n1,1\n3,3"), "flat");
    assert_eq!(code(b"7"), "too-few-points");
    let line = br#"{"type": "LineString", "coordinates": [[0, 0], [1, 0]]}"#;
    assert_eq!(code(line), "too-few-points");
}

#[test]
fn gaps_are_said_and_the_rest_is_read() {
    let content = read_file(b"x;y\n0;0\n4;0\nNaN;2\n4;3\n0;NA\n0;3", ReadAs::Guess).expect("a table");
    assert_eq!(codes(&content), ["gaps"]);
}

#[test]
fn a_million_points_are_thinned() {
    let mut text = String::new();
    for i in 0..1_000_000 {
        let p = DVec2::from_angle(f64::from(i) * 2e-6 * std::f64::consts::PI) * 50.0;
        let _ = writeln!(text, "{:.5},{:.5}", p.x, p.y);
    }
    let content = read_file(text.as_bytes(), ReadAs::Guess).expect("a circle");
    assert_eq!(codes(&content), ["thinned"]);
    let FileContent::Outlines { outlines, .. } = content else { panic!("an outline") };
    assert_eq!(outlines[0].outline.points().len(), MAX_OUTLINE);
    assert!((outlines[0].outline.area() - 7853.98).abs() < 0.01);
    assert_eq!(code("1,2\n".repeat(17 << 20).as_bytes()), "too-large");
}

#[test]
fn what_crosses_itself_is_kept_with_a_warning() {
    let content = read_file(b"0,0\n10,10\n10,0\n0,10\n", ReadAs::Guess).expect("an hourglass");
    assert_eq!(codes(&content), ["crossing"]);
    let FileContent::Outlines { outlines, .. } = content else { panic!("an outline") };
    assert_eq!(outlines[0].crossings, Some(1));
}

#[test]
fn files_are_what_is_in_them_whatever_they_are_called() {
    assert_eq!(sniff(b"\x89PNG\r\n\x1a\n...."), FileKind::Picture("PNG"));
    assert_eq!(code(b"\x89PNG\r\n\x1a\n...."), "picture");
    assert_eq!(code(b"%PDF-1.7"), "unknown-file");
    assert_eq!(code(b"\x01\x02\x03"), "unknown-file");
    assert_eq!(code(b""), "empty");
    assert_eq!(code(b"Dear Sir,\nthis is a leaf.\n"), "no-numbers");
    assert_eq!(code(b"<html><body>1</body></html>"), "no-numbers");
}

#[test]
fn what_cannot_be_read_is_named_with_a_way_out() {
    for (bytes, is, way_out) in [
        (&b"\0\0\0\x18ftypheic\0\0\0\0mif1heic"[..], "This is a HEIC picture", "Save it as JPEG"),
        (b"II*\0\x08\0\0\0", "This is a TIFF picture", "Save it as JPEG"),
        (b"%PDF-1.7", "This is a PDF", "Save a drawing in it as SVG"),
        (
            b"PK\x03\x04[Content_Types].xml xl/workbook.xml",
            "This is a spreadsheet (xlsx)",
            "Save its sheet as CSV",
        ),
        (b"PK\x03\x04[Content_Types].xml word/a.xml", "This is a document (docx)", "as plain text or CSV"),
    ] {
        let said = read_file(bytes, ReadAs::Guess).expect_err("no text").to_string();
        assert!(said.starts_with(is) && said.contains(way_out), "{said}");
    }
}

#[test]
fn what_stands_before_the_beginning_may_be_long() {
    let words = "the words of a licence\n".repeat(5_000);
    let drawing = svg("<path d='M10 10H90V60H10Z'/>");
    let drawing = drawing.strip_prefix("<?xml version=\"1.0\"?>").expect("a declaration");
    let json = r#"{"type": "Polygon", "coordinates": [[[0, 0], [400, 0], [400, 10], [0, 10], [0, 0]]]}"#;
    for text in [
        format!("<?xml version='1.0'?><!--\n{words}--><!DOCTYPE svg>{drawing}"),
        format!("{}{json}", " \n".repeat(9_000)),
        format!("// {}\n{json}", words.replace('\n', "\n// ")),
    ] {
        assert_eq!(outlines(&text)[0].outline.area(), 4000.0, "{}", &text[..30]);
    }
}

#[test]
fn a_grown_leaf_goes_through_each_format() {
    let leaf = maple_leaf(3);
    let list = |from: &str, between: &str, sign: f64| {
        leaf.iter().map(|p| format!("{}{from}{}", p.x, sign * p.y)).collect::<Vec<_>>().join(between)
    };
    let scaled =
        format!(r#"{{"type": "LineString", "coordinates": [[{}], [1000, 0]]}}"#, list(",", "],[", 1.0));
    assert_eq!(outlines(&list(",", "\n", 1.0))[0].outline.points(), leaf);
    // A drawing has single precision, as in browsers.
    let drawn = outlines(&svg(&format!("<polygon points='{}'/>", list(",", " ", -1.0))));
    assert_eq!(drawn[0].outline.points().len(), leaf.len());
    assert!(drawn[0].outline.points().iter().zip(&leaf).all(|(a, b)| a.distance(*b) < 1e-7));
    // No degrees are as large as that: it stays in its own units.
    let found = outlines(&scaled);
    let near = |(a, b): (&DVec2, &DVec2)| a.distance(*b) < 1e-12;
    assert!(found[0].outline.points().iter().zip(&leaf).all(near));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(frond_testing::cases(400)))]

    #[test]
    fn no_text_panics(text in "\\PC{0,200}") {
        let _ = read_file(text.as_bytes(), ReadAs::Guess);
    }

    #[test]
    fn no_bytes_panic(bytes in proptest::collection::vec(any::<u8>(), 0..300)) {
        let _ = sniff(&bytes);
        let _ = read_file(&bytes, ReadAs::Series);
    }

    #[test]
    fn no_path_panics(d in "[MmLlHhVvCcSsQqTtAaZz0-9 ,.+e-]{0,80}", transform in "[a-zX-Y0-9(), .-]{0,40}") {
        let text = svg(&format!("<path transform='{transform}' d='M0 0{d}'/><polygon points='{d}'/>"));
        let _ = read_file(text.as_bytes(), ReadAs::Guess);
    }

    #[test]
    fn no_table_panics(text in "[0-9,;\t .eNainf\n\r#-]{0,200}") {
        for read_as in [ReadAs::Guess, ReadAs::Outlines, ReadAs::Series] {
            match read_file(text.as_bytes(), read_as) {
                Ok(FileContent::Series { points, .. }) => {
                    prop_assert!(points.len() >= 3 && points.windows(2).all(|pair| pair[0].x < pair[1].x));
                }
                Ok(FileContent::Outlines { outlines, .. }) => prop_assert!(outlines[0].outline.points().len() >= 4),
                Err(error) => prop_assert!(!error.to_string().is_empty()),
            }
        }
    }

    #[test]
    fn no_json_panics(inside in "[\\[\\]0-9,.{}e\"a-]{0,120}") {
        let _ = read_file(format!("{{\"type\": \"Polygon\", \"coordinates\": [{inside}").as_bytes(), ReadAs::Guess);
        let _ = read_file(format!("[[{inside}]]").as_bytes(), ReadAs::Guess);
    }
}
