//! Links, and their words.

use frond_fit::{ClosedCurve, MAX_KNOTS, Spline};
use frond_scene::{decode, decode_morph, encode, pack, unpack};

use crate::reader::Reader;

/// Links.
pub const LINK: Reader = Reader {
    name: "link",
    read: link,
    words: &[
        "v=1",
        "v=2",
        "&",
        "=",
        "a=fern",
        "b=gasket",
        "a=maps:0.5,0,0,0.5,0,0;0.5,0,0,0.5,0.5,0",
        "a-name=x",
        "%C3%BC",
        "%00",
        "%",
        "a-weights=1,2",
        "mode=linear",
        "path=drawn:0.2,0.7;0.4,0.4,0.1",
        "path=straight",
        "t=0.5",
        "match=2,1,3",
        "turns=1,-1,0",
        "colour=grid",
        "palette=ff8800,00aa55",
        "compare=1",
        "view=0,0,2",
        "locus=m:0,0.7,9",
        "locus=5:0,0,1",
        "at=0.5,0.7",
        "tool=space",
        "tool=fit",
        "tool=deform",
        "mesh=4x4:0,0,1,1",
        "bend=0,9,0.75",
        "keys=0:6,0.1,0.2;0.5:6,-0.1,0.2",
        "spin=scaled",
        "loop=4",
        "phase=0.25",
        "once=2.5",
        "join=raw",
        "terms=last",
        "bent=0",
        "tint=0,8,1:all:ff0000,00ff00,0000ff,ffffff",
        "picture=3",
        "curve-a=maple",
        "curve-b=oak",
        "curve-b=curve-a",
        "curve-a=fitted",
        "curve-a=spline",
        "fitted=snowflake",
        "fit=outline:closed,260,0",
        "fit=outline:spline,260,0",
        "fit=plane:closed,260,0",
        "bytes=50",
        "graph=fif:0.5,0.4,0.6,0,0,0,1;0.5,-0.6,0.4,0.5,1,0,1",
        "plane=0,0,0;1,1,0;2,0,0:0.5,0,0,0.5,0,2",
        "directed-a=snowflake",
        "directed-b=crystal",
        "directed-a=states:1,0.5,0,0,0.5,0,0;2,0.5,0,0,0.5,0.5,0:2,0.5,0,0,0.5,0,0",
        "directed-half=signs",
        "space=o:sponge/l:height,-0.56,0.55,0.35,0.75,0.25",
        "space-view=0,0,0,6,0.5,0.42,0.7,eye",
        "space-own=1",
        "space-at=1",
        "/to:dragon-curled/way:auto,0.2,0.4",
        "~b3,3,3,0,3,0.5,0;26,0.2,0,0.4",
        ";",
        ",",
        ":",
    ],
};

/// The word of space.
pub const SPACE: Reader = Reader {
    name: "space",
    read: |bytes| text(bytes, space),
    words: &[
        "o:sponge",
        "/",
        "~",
        "o:maps;0.5,0,0,0,0.5,0,0,0,0.5,0,0,0",
        "~nMy%20own",
        "~m1,0,0,0,1,0,0,0,1,2,0,0",
        "~cd5dde6",
        "~c",
        "~b3,3,3,0,3,0.5,0;26,0.2,0,0.4",
        "/l:height,-0.56,0.55,0.35,0.75,0.25",
        "/f:0.8,0.35,0.8,0.5,0.2,1",
        "/b:0e1015",
        "/b:page",
        "/to:dragon-curled",
        "/mode:linear",
        "/way:drawn;0.2,0.4;0.6,0.5",
        "/t:0.5",
        "/match:2,1",
        "/turns:1,0,-1",
        "/time:6,1,smooth",
        "/time:6,2,straight",
        "/k:0,inout",
        "/k:3,hold",
        "~v12,0,0,12,-1.57,0,0.46",
        "~p0,1,0,0,0,1,0,0,0,1,0,0,0",
        "~q0;0.5,0,0,0,0.5,0,0,0,0.5,0,0,0",
        "~t0.5",
        "~b0,27;3,0.1,0.2,0.3",
        ";",
        ",",
        ":",
        "o:natural-0",
    ],
};

/// The word of a closed curve.
pub const CURVE: Reader =
    Reader { name: "curve", read: |bytes| text(bytes, curve), words: &["A", "_", "-", "AAAA"] };

/// The word of a spline.
pub const SPLINE: Reader =
    Reader { name: "spline", read: |bytes| text(bytes, spline), words: &["A", "_", "-", "AAAA"] };

/// Words are text: what is none does not reach them.
fn text(bytes: &[u8], read: fn(&str)) {
    if let Ok(text) = str::from_utf8(bytes) {
        read(text);
    }
}

fn link(bytes: &[u8]) {
    let text = String::from_utf8_lossy(bytes);
    let _ = decode_morph(&text);
    let (scene, _) = decode(&text);
    let written = encode(&scene).unwrap_or_else(|error| panic!("{error}\n{text}"));
    let (again, problem) = decode(&written);
    assert_eq!(problem, None, "{written}");
    assert_eq!(again, scene, "{written}");
    assert_eq!(encode(&again).as_ref(), Ok(&written));
    if let Some(part) = &scene.space {
        space(&part.packed);
    }
}

fn space(word: &str) {
    let Ok(space) = unpack(word) else { return };
    let written = pack(&space).unwrap_or_else(|error| panic!("{error}\n{word}"));
    assert_eq!(unpack(&written).as_ref(), Ok(&space), "{written}");
    assert_eq!(pack(&space), Ok(written));
}

fn curve(word: &str) {
    let Ok(curve) = ClosedCurve::from_text(word) else { return };
    let written = curve.to_text().unwrap_or_else(|error| panic!("{error}\n{word}"));
    assert_eq!(ClosedCurve::from_text(&written).as_ref(), Ok(&curve), "{written}");
    assert_eq!(curve.to_text(), Ok(written));
    assert!(curve.knots.len() <= MAX_KNOTS);
    assert!(curve.knots.iter().all(|knot| knot.is_finite()), "{curve:?}");
}

fn spline(word: &str) {
    let Ok(spline) = Spline::from_text(word) else { return };
    let polygon = spline.polygon();
    assert!(
        polygon.knots.len() <= MAX_KNOTS && polygon.knots.iter().all(|knot| knot.is_finite()),
        "{spline:?}"
    );
    let written = spline.to_text().unwrap_or_else(|error| panic!("{error}\n{word}"));
    assert_eq!(Spline::from_text(&written).as_ref(), Ok(&spline), "{written}");
}
