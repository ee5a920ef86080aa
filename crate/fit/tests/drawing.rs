//! Drawings are read as browsers show them: each expected area was worked out by hand, and seen in Chromium.

use frond_fit::{FileContent, NamedOutline, ReadAs, read_file};

fn read(text: &str) -> (Vec<NamedOutline>, String) {
    match read_file(text.as_bytes(), ReadAs::Guess) {
        Ok(FileContent::Outlines { outlines, remarks, .. }) => {
            (outlines, remarks.into_iter().map(|remark| remark.message).collect::<Vec<_>>().join(" "))
        }
        other => panic!("{other:?}: {text}"),
    }
}

fn svg(inside: &str) -> String {
    format!("<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100'>{inside}</svg>")
}

/// Left, top, right, bottom, with y down as in the drawing, and the area.
fn measures(outline: &NamedOutline) -> [f64; 5] {
    let (low, high) = outline.outline.bounds();
    [low.x, -high.y, high.x, -low.y, outline.outline.area()]
}

#[track_caller]
fn is(inside: &str, wanted: [f64; 5]) {
    let (found, _) = read(&svg(inside));
    let found = measures(&found[0]);
    let near = found.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 1e-3 * (1.0 + b.abs()));
    assert!(near, "{found:?}, not {wanted:?}: {inside}");
}

const PI: f64 = std::f64::consts::PI;

#[test]
fn arcs_go_round_the_centre_that_their_flags_say() {
    // From (10, 0) to (0, 10) with radius 10 there are two circles, and two ways on each: a segment of a quarter, and
    // what is left of the disc.
    let small = 100.0 * (PI / 4.0 - 0.5);
    let large = 100.0 * PI - small;
    is("<path d='M30 20A10 10 0 0 1 20 30Z'/>", [20.0, 20.0, 30.0, 30.0, small]);
    is("<path d='M30 20A10 10 0 0 0 20 30Z'/>", [20.0, 20.0, 30.0, 30.0, small]);
    is("<path d='M30 20A10 10 0 1 1 20 30Z'/>", [20.0, 20.0, 40.0, 40.0, large]);
    is("<path d='M30 20A10 10 0 1 0 20 30Z'/>", [10.0, 10.0, 30.0, 30.0, large]);
    // Flags need no space, radii that are too small grow, and their signs do not count.
    is("<path d='M50 50a5 5 0 0110 0z'/>", [50.0, 45.0, 60.0, 50.0, 12.5 * PI]);
    is("<path d='M50 50A1-1 0 0 1 60 50Z'/>", [50.0, 45.0, 60.0, 50.0, 12.5 * PI]);
    // Turned by a quarter, the long axis stands upright: half an ellipse of 10 and 20.
    is("<path d='M40 50A10 5 90 0 1 60 50Z'/>", [40.0, 30.0, 60.0, 50.0, 100.0 * PI]);
    is(
        "<path d='M40 50A10 5 90 0 1 60 50Z' transform='matrix(-1 0 0 1 100 0)'/>",
        [40.0, 30.0, 60.0, 50.0, 100.0 * PI],
    );
    // Four arcs, as Inkscape draws a circle.
    let circle =
        "<path d='M80 50A30 30 0 0 1 50 80A30 30 0 0 1 20 50A30 30 0 0 1 50 20A30 30 0 0 1 80 50Z'/>";
    is(circle, [20.0, 20.0, 80.0, 80.0, 900.0 * PI]);
}

#[test]
fn nested_drawings_and_symbols_have_their_own_boxes() {
    let square = "<path d='M0 0H10V10H0Z'/>";
    is(
        &format!(
            "<svg x='10' y='10' width='40' height='20' viewBox='0 0 10 10' preserveAspectRatio='none'>{square}</svg>"
        ),
        [10.0, 10.0, 50.0, 30.0, 800.0],
    );
    is(
        &format!("<svg x='10' y='10' width='40' height='20' viewBox='0 0 10 10'>{square}</svg>"),
        [20.0, 10.0, 40.0, 30.0, 400.0],
    );
    is(
        &format!(
            "<svg width='40' height='20' viewBox='0 0 10 10' preserveAspectRatio='xMaxYMid'>{square}</svg>"
        ),
        [20.0, 0.0, 40.0, 20.0, 400.0],
    );
    // What is filled is cut off beyond its place.
    is(
        &format!(
            "<svg width='40' height='20' viewBox='0 0 10 10' preserveAspectRatio='xMidYMid slice'>{square}</svg>"
        ),
        [0.0, 0.0, 40.0, 20.0, 800.0],
    );
    is(
        &format!(
            "<symbol id='s' viewBox='0 0 10 10'>{square}</symbol><use href='#s' x='5' y='6' width='30' height='30'/>"
        ),
        [5.0, 6.0, 35.0, 36.0, 900.0],
    );
    is(
        "<symbol id='s' viewBox='0 0 200 200'><circle cx='50%' cy='100' r='40'/></symbol><use href='#s' width='50' height='50'/>",
        [15.0, 15.0, 35.0, 35.0, 100.0 * PI],
    );
    // A size of the page that is below 0 is none.
    let (found, _) = read(
        "<svg xmlns='http://www.w3.org/2000/svg' width='-20' height='-5'><rect width='9' height='4'/></svg>",
    );
    assert_eq!(found[0].outline.area(), 36.0);
    // The page itself may be stretched, and has units.
    let (found, _) = read(
        "<svg xmlns='http://www.w3.org/2000/svg' width='2in' height='48pt' viewBox='0 0 10 10' preserveAspectRatio='none'><path d='M1 1H9V9H1Z'/></svg>",
    );
    assert!((found[0].outline.area() - 0.64 * 192.0 * 64.0).abs() < 1.0);
}

#[test]
fn style_sheets_move_and_measure_shapes() {
    let path = "d='M10 40H90V60H10Z'";
    is(
        &format!("<path style='transform: rotate(90deg); transform-origin: 50px 50px' {path}/>"),
        [40.0, 10.0, 60.0, 90.0, 1600.0],
    );
    is(
        &format!("<path transform='rotate(90)' transform-origin='50 50' {path}/>"),
        [40.0, 10.0, 60.0, 90.0, 1600.0],
    );
    is(
        &format!("<path style='rotate:.25turn;transform-origin:center' {path}/>"),
        [40.0, 10.0, 60.0, 90.0, 1600.0],
    );
    is(
        &format!("<style>.a{{scale:.5 1}} path.a{{translate:10px 10%}}</style><path class='a' {path}/>"),
        [15.0, 50.0, 55.0, 70.0, 800.0],
    );
    is(
        "<path style='transform:scale(.5);transform-box:fill-box;transform-origin:100% 0' d='M10 40H90V60H10Z'/>",
        [50.0, 40.0, 90.0, 50.0, 400.0],
    );
    is(
        "<g style='transform-box:fill-box;transform:rotate(90deg);transform-origin:center'><rect width='40' height='20' x='30' y='40'/></g>",
        [40.0, 30.0, 60.0, 70.0, 800.0],
    );
    is(
        "<style>#c{cx:30px;cy:40px;r:10px}</style><circle id='c' r='1'/>",
        [20.0, 30.0, 40.0, 50.0, 100.0 * PI],
    );
    is("<style>path{d:path('M0 0H8V8H0Z')}</style><path d='M0 0H1V1H0Z'/>", [0.0, 0.0, 8.0, 8.0, 64.0]);
    // Of two rules the one that names the class counts, and what is important before all.
    let sheet = "<style>.b{translate:5px 0} path{translate:9px 0; rotate:0deg!important}</style>";
    is(&format!("{sheet}<path class='b' style='rotate:90deg' {path}/>"), [15.0, 40.0, 95.0, 60.0, 1600.0]);
}

#[test]
fn what_is_hidden_is_left_out_and_told() {
    let (shown, large) = ("<rect id='shown' width='10' height='10'/>", "width='90' height='90'");
    for hidden in [
        format!("<rect {large} visibility='hidden'/>"),
        format!("<rect {large} style='visibility:collapse'/>"),
        format!("<g opacity='0'><rect {large}/></g>"),
        format!("<rect {large} fill='none'/>"),
        format!("<rect {large} fill-opacity='0'/>"),
        format!("<style>.h{{opacity:0}}</style><rect class='h' {large}/>"),
    ] {
        let (found, remarks) = read(&svg(&format!("{hidden}{shown}")));
        assert_eq!(found.len(), 1, "{hidden}");
        assert_eq!(
            (found[0].name.as_str(), remarks.as_str()),
            ("shown", "A shape that is hidden is left out."),
            "{hidden}"
        );
    }
    let (found, _) =
        read(&svg(&format!("<style>.h{{display:none}}</style><g class='h'><rect {large}/></g>{shown}")));
    assert_eq!(found.len(), 1);
    // A child may be visible where its group is not.
    let (found, _) =
        read(&svg(&format!("<g visibility='hidden'><rect {large} visibility='visible'/>{shown}</g>")));
    assert_eq!(found[0].outline.area(), 8100.0);
    let (found, remarks) = read(&svg("<rect id='a' width='9' height='9' fill='none'/>"));
    assert_eq!(
        (found.len(), remarks.as_str()),
        (1, "No shape of the drawing is visible, so that those are read that are hidden.")
    );
}

#[test]
fn clip_paths_and_masks_cut() {
    let clip = "<clipPath id='c'><path d='M30 30H70V70H30Z'/></clipPath>";
    is(
        &format!("{clip}<g style='clip-path:url(#c)'><path d='M10 10H50V50H10Z'/></g>"),
        [30.0, 30.0, 50.0, 50.0, 400.0],
    );
    is(
        &format!("<style>.k{{clip-path:url(#c)}}</style>{clip}<path class='k' d='M10 10H50V50H10Z'/>"),
        [30.0, 30.0, 50.0, 50.0, 400.0],
    );
    is(
        "<clipPath id='c' clipPathUnits='objectBoundingBox'><rect width='.5' height='1'/></clipPath><rect x='20' y='20' width='40' height='20' clip-path='url(#c)'/>",
        [20.0, 20.0, 40.0, 40.0, 400.0],
    );
    // A photograph that is cut out has the outline that it is cut out by.
    is(
        &format!("{clip}<image clip-path='url(#c)' width='100' height='100' href='leaf.jpg'/>"),
        [30.0, 30.0, 70.0, 70.0, 1600.0],
    );
    // White lets through, black does not.
    let mask = "<mask id='m'><rect x='30' y='30' width='40' height='40' fill='#fff'/><rect x='30' y='30' width='40' height='20'/></mask>";
    is(&format!("{mask}<path mask='url(#m)' d='M10 10H90V90H10Z'/>"), [30.0, 50.0, 70.0, 70.0, 800.0]);
    // The clip path goes where a use goes.
    is("<symbol id='s' viewBox='0 0 10 10'><rect width='10' height='10'/></symbol><clipPath id='c'><rect width='5' height='10'/></clipPath>
        <use href='#s' x='20' y='20' width='10' height='10' clip-path='url(#c)'/>", [20.0, 20.0, 25.0, 30.0, 50.0]);
    // Nothing is left of the one, so that the other is first.
    let (found, _) = read(&svg(&format!(
        "{clip}<rect clip-path='url(#c)' width='20' height='20'/><rect id='b' width='4' height='4'/>"
    )));
    assert_eq!((found.len(), found[0].name.as_str()), (1, "b"));
}

#[test]
fn texts_that_are_not_quite_xml_are_read() {
    let path = "<path d='M0 0H9V9H0Z'/>";
    for text in [
        // Entities, as Illustrator has them for its own namespaces.
        format!(
            "<!DOCTYPE svg [<!ENTITY ns 'http://example.org/'><!ENTITY s 'fill:red'>]><svg xmlns='http://www.w3.org/2000/svg' xmlns:i='&ns;'><g style='&s;'>{path}</g></svg>"
        ),
        format!("<svg xmlns='http://www.w3.org/2000/svg'><!-- no <!ENTITY here -->{path}</svg>"),
        // Parts of a page: no namespaces, prefixes that are not declared, signs that are not escaped.
        format!("<svg viewBox='0 0 9 9'>{path}</svg>"),
        format!("<svg><g inkscape:label='a' sodipodi:type='b'>{path}<use xlink:href='#x'/></g></svg>"),
        format!("<svg><title>Leaf & stalk &nbsp;</title>{path}</svg>"),
        format!("<!DOCTYPE html><html><body><br><p>A leaf: <svg viewBox='0 0 9 9'>{path}</svg></body>"),
    ] {
        let (found, _) = read(&text);
        assert!((found[0].outline.area() - 81.0).abs() < 1e-9, "{text}");
    }
}

#[test]
fn what_is_not_looked_at_is_told() {
    let (_, remarks) = read(&svg(
        "<text>a</text><image href='a.png' width='9' height='9'/><foreignObject/><path d='M0 0H9V9H0V5x'/>",
    ));
    assert_eq!(
        remarks.split(". ").next(),
        Some("Not looked at: what follows a mistake in a path, foreign objects, pictures, texts")
    );
    let (_, remarks) = read(&svg("<path style='transform:turn(3)' d='M0 0H9V9H0Z'/>"));
    assert_eq!(remarks, "Not looked at: transforms that could not be read.");
}
