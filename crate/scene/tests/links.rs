//! Whatever link is opened, what it shows is written as a link that shows it again.
//!
//! Links are put together from words of `links.txt`, from words of the same forms with hostile numbers, and with
//! damage.

use base64::Engine as _;
use base64::engine::general_purpose::URL_SAFE_NO_PAD;
use frond_deform::Continuity;
use frond_fit::{Node, Spline};
use frond_scene::{MAX_LINK, decode, encode, pack, unpack};
use glam::DVec2;
use proptest::prelude::*;
use proptest::sample::select;

type Word = BoxedStrategy<String>;

/// The words of the links that were given out, each key with its value.
fn given() -> Vec<String> {
    let lines = include_str!("links.txt").lines().filter(|line| !line.starts_with("//"));
    let words = lines.flat_map(|line| line.split('&')).map(ToOwned::to_owned);
    words.filter(|word| !word.is_empty()).collect()
}

fn number() -> Word {
    const WORDS: &[&str] = &[
        "0",
        "-0",
        "1",
        "-1",
        "0.5",
        "2",
        ".25",
        "5.",
        "1e-5",
        "1e15",
        "1e16",
        "1e99",
        "1e101",
        "1e-320",
        "1e308",
        "-1e308",
        "1e400",
        "NaN",
        "inf",
        "0.30000000000000004",
        "4503599627370497.5",
        "2.2250738585072014e-308",
        "+3",
        "007",
        "",
        "x",
        "1e5",
    ];
    prop_oneof![
        3 => select(WORDS).prop_map(ToOwned::to_owned),
        2 => (-2.0..2.0_f64).prop_map(|x| x.to_string()),
        2 => (0..12_u32).prop_map(|x| x.to_string()),
        1 => any::<u64>().prop_map(|bits| format!("{:?}", f64::from_bits(bits))),
    ]
    .boxed()
}

/// Numbers that mostly are what is asked for.
fn mild() -> Word {
    prop_oneof![12 => (0.0..0.5_f64).prop_map(|x| format!("{x:.3}")), 1 => number()].boxed()
}

fn joined(word: Word, count: std::ops::Range<usize>, by: &'static str) -> Word {
    proptest::collection::vec(word, count).prop_map(move |words| words.join(by)).boxed()
}

/// A curve: of some bytes, or of a sound one whose grid is another.
fn curve() -> Word {
    let float = prop_oneof![
        2 => -2.0..2.0_f64,
        2 => any::<u64>().prop_map(f64::from_bits),
        2 => (-320..308_i32, -1.0..1.0_f64).prop_map(|(power, x)| x * 10_f64.powi(power)),
        1 => Just(0.0),
    ];
    let tail = proptest::collection::vec(any::<u8>(), 6..60);
    let hostile = (proptest::array::uniform3(float.clone()), 3..7_u8, any::<u8>(), tail).prop_map(
        |(numbers, count, order, tail)| {
            let head = numbers.into_iter().flat_map(|x| x.to_bits().to_be_bytes());
            let bytes: Vec<u8> =
                [1].into_iter().chain(head).chain([0, count << 3 | order & 7]).chain(tail).collect();
            URL_SAFE_NO_PAD.encode(bytes)
        },
    );
    let presets = frond_fit::curve_presets();
    let sound = (select(presets), 1e-8..1e-2_f64, proptest::option::of(float)).prop_map(
        |(preset, precision, step)| {
            let mut bytes = preset.curve.to_bytes(precision).unwrap_or_default();
            if let (Some(step), Some(place)) = (step, bytes.get_mut(17..25)) {
                place.copy_from_slice(&step.to_bits().to_be_bytes());
            }
            URL_SAFE_NO_PAD.encode(bytes)
        },
    );
    let own = prop_oneof![hostile, sound].prop_map(|text| format!("curve:{text}"));
    let named = vec!["maple", "sugar-maple", "snowflake", "willow"];
    prop_oneof![1 => select(named).prop_map(ToOwned::to_owned), 4 => own].boxed()
}

/// A spline: of some letters, or of a sound one.
fn spline() -> Word {
    let sound = (proptest::collection::vec((-400..400_i32, -400..400_i32, any::<bool>()), 3..60), -9..9_i32)
        .prop_map(|(nodes, size)| {
            let node = |&(x, y, on): &(i32, i32, bool)| Node { at: DVec2::new(x.into(), y.into()), on };
            let spline = Spline { nodes: nodes.iter().map(node).collect(), grid: f64::from(size).exp2() };
            spline.to_text().unwrap_or_default()
        });
    prop_oneof![1 => "[-_0-9A-Za-z]{0,40}".prop_map(|text| text), 3 => sound].boxed()
}

/// A graph-directed shape: of the gallery, or of some states that copy what may not be there.
fn directed() -> Word {
    // There are many numbers, each of which has to be one.
    let entry = prop_oneof![60 => (0.0..0.5_f64).prop_map(|x| format!("{x:.3}")), 1 => number()].boxed();
    let map = (prop_oneof![30 => 1..3_u32, 1 => 0..70_u32], joined(entry, 6..7, ","))
        .prop_map(|(from, row)| format!("{from},{row}"))
        .boxed();
    let states = joined(joined(map, 1..4, ";"), 2..5, ":").prop_map(|states| format!("states:{states}"));
    prop_oneof![1 => select(vec!["quilt", "sun", "rauzy", "nothing"]).prop_map(ToOwned::to_owned), 4 => states].boxed()
}

/// A word of space: parts of what is there, with numbers of all kinds.
fn space() -> Word {
    let shape = prop_oneof![
        4 => select(vec!["sponge", "tetrahedron", "natural-1", "natural-01", "tree", "nothing"]).prop_map(ToOwned::to_owned),
        2 => joined(joined(mild(), 12..13, ","), 1..4, ";").prop_map(|rows| format!("maps;{rows}~nA%7Eb~x")),
    ];
    let row = joined(mild(), 12..13, ",");
    let field = prop_oneof![
        Just(String::new()),
        row.clone().prop_map(|row| format!("~m{row}")),
        select(vec!["~c", "~cff0088", "~cFF0088", "~cx", "~z"]).prop_map(ToOwned::to_owned),
    ];
    let object = (shape.clone(), field).prop_map(|(shape, field)| format!("o:{shape}{field}"));
    let key = (mild(), select(vec!["even", "hold"]), joined(mild(), 7..8, ","), 0..4_u32, row, mild())
        .prop_map(|(at, ease, view, index, row, t)| {
            format!("k:{at},{ease}~v{view}~p{index},{row}~q{index};{row}~t{t}")
        });
    let part = prop_oneof![
        3 => object.clone(),
        1 => (select(vec!["map", "height"]), joined(mild(), 5..6, ",")).prop_map(|(paint, list)| format!("l:{paint},{list}")),
        1 => shape.prop_map(|shape| format!("to:{shape}")),
        1 => (select(vec!["auto", "straight", "drawn"]), joined(joined(mild(), 2..4, ","), 0..3, ";"))
            .prop_map(|(kind, points)| format!("way:{kind};{points}").trim_end_matches(';').to_owned()),
        1 => mild().prop_map(|t| format!("t:{t}")),
        1 => select(vec!["match:1,2,3,4", "match:2,1", "turns:0,0,0,0", "turns:0,1", "mode:linear", "mode:polar", "later:1"])
            .prop_map(ToOwned::to_owned),
        1 => mild().prop_map(|seconds| format!("time:{seconds},1,smooth")),
        2 => key,
    ];
    (object, proptest::collection::vec(part, 0..5))
        .prop_map(|(first, parts)| [&[first][..], &parts].concat().join("/"))
        .boxed()
}

/// A key and a value of its form.
fn word() -> Word {
    let list = |key: &'static str, numbers: Word, count| {
        joined(numbers, count, ",").prop_map(move |text| format!("{key}={text}"))
    };
    let of = |key: &'static str, choices: &'static [&'static str]| {
        select(choices).prop_map(move |text| format!("{key}={text}"))
    };
    let points = |count| joined(joined(mild(), count, ","), 0..4, ";");
    let moves = |count| {
        joined((1..20_u32, mild(), mild()).prop_map(|(i, x, y)| format!("{i},{x},{y}")).boxed(), count, ",")
    };
    let shapes = prop_oneof![
        (select(vec!["a", "b"]), joined(joined(mild(), 6..7, ","), 1..4, ";"))
            .prop_map(|(key, rows)| format!("{key}=maps:{rows}")),
        (select(vec!["a-name", "b-name", "curve-a-name", "fitted-name", "spline-name"]), "\\PC{0,12}")
            .prop_map(|(key, name)| format!("{key}={name}")),
        of("mode", &["polar", "linear", "x"]),
        (select(vec!["auto", "straight", "drawn"]), points(2..4))
            .prop_map(|(kind, text)| format!("path={kind}:{text}")),
        list("t", number(), 1..2),
        of("match", &["1,2,3", "3,2,1", "1,2", "1"]),
        of("turns", &["0,0,0", "0,-0,+0", "0,1,0", "-16,0,16", "0"]),
        of("colour", &["map", "address", "grid"]),
        of("compare", &["0", "1"]),
        list("view", number(), 3..4),
        (select(vec!["morph", "m", "2", "5", "+64", "65"]), joined(number(), 0..5, ","))
            .prop_map(|(family, text)| format!("locus={family}:{text}")),
        of("locus", &["morph", "morph:", "morph:0.5,0.5,1", "morph:0.5,0.5,1,0", "m:", "m:0,0,1,-0"]),
        list("at", mild(), 2..4),
    ];
    let bends = prop_oneof![
        (
            select(vec!["mesh=4x4:", "mesh=2x3:", "mesh=+2x02:"]),
            select(vec!["0,0,1,1", "-1e99,0,1e99,1e-320", "0,0,0,1"])
        )
            .prop_map(|(a, b)| format!("{a}{b}")),
        (mild(), moves(0..4), mild(), moves(0..4)).prop_map(|(s, a, t, b)| format!("keys={s}:{a};{t}:{b}")),
        list("bend", prop_oneof![mild(), (0..9_u32).prop_map(|x| x.to_string())].boxed(), 3..8),
        list("phase", number(), 1..2),
        list("loop", number(), 1..2),
        list("once", number(), 1..2),
        of("spin", &["none", "scaled"]),
        of("join", &["auto", "raw"]),
        of("terms", &["all", "last"]),
        of("picture", &["2", "3"]),
        of("bent", &["0", "1"]),
        of("tint", &["0,8,1:all:ff0000,00FF00,0000ff,ffffff", "-0,-0,-0:last:ff0000,00ff00,0000ff,ffffff"]),
    ];
    let fits = prop_oneof![
        (select(vec!["curve-a", "curve-b", "fitted"]), curve())
            .prop_map(|(key, text)| format!("{key}={text}")),
        (select(vec!["outline:closed", "outline:spline", "graph:collage"]), 10..300_u32, number())
            .prop_map(|(how, count, x)| format!("fit={how},{count},{x}")),
        (mild(), mild(), number())
            .prop_map(|(c, e, b)| format!("graph=fif:0.5,{b},{c},0,0,0,1;0.5,0,{c},0.5,{e},0,1")),
        spline().prop_map(|text| format!("spline={text}")),
        (20..200_u32).prop_map(|bytes| format!("bytes={bytes}")),
        (joined(mild(), 7..8, ","), select(vec!["", ",eye"]))
            .prop_map(|(view, eye)| format!("space-view={view}{eye}")),
        of("space-own", &["0", "1"]),
        list("space-at", number(), 1..2),
        of("tool", &["morph", "deform", "fit", "space"]),
        of("v", &["1", "2", "0"]),
    ];
    let spaces = space().prop_map(|text| format!("space={text}"));
    let curves = (curve(), curve()).prop_map(|(a, b)| format!("curve-a={a}&curve-b={b}"));
    // Ends that are the other one, or the fit's.
    let taken = (curve(), curve(), spline(), 0..7_u32).prop_map(|(own, fitted, word, which)| match which {
        4 => format!("curve-a=spline:{word}&curve-b=curve-a"),
        5 => format!("curve-a={own}&curve-b=spline:{word}"),
        6 => format!("curve-a=spline&curve-b={own}&spline={word}"),
        0 => format!("curve-a={own}&curve-b=curve-a"),
        1 => format!("curve-a={own}&curve-b=fitted&fitted={fitted}"),
        2 => format!("curve-a=fitted&curve-b={own}&fitted={fitted}"),
        _ => format!("curve-a=fitted&curve-b=curve-a&fitted={fitted}"),
    });
    let graphs = (directed(), directed(), "\\PC{0,12}")
        .prop_map(|(a, b, name)| format!("directed-a={a}&directed-b={b}&directed-a-name={name}"));
    prop_oneof![3 => shapes, 4 => bends, 3 => fits, 1 => spaces, 1 => curves, 1 => taken, 1 => graphs, 3 => select(given())].boxed()
}

/// A few words, sometimes with damage: some characters are others, or gone.
fn link() -> Word {
    let damage =
        proptest::option::weighted(0.3, (0..4000_usize, 0..3_usize, "[-0-9a-zA-Z.,:;=&_~/+#%é]{0,3}"));
    (proptest::collection::vec(word(), 1..7), damage)
        .prop_map(|(words, damage)| {
            let mut link: Vec<char> = words.join("&").chars().collect();
            if let Some((at, gone, with)) = damage {
                let at = at % link.len();
                link.splice(at..(at + gone).min(link.len()), with.chars());
            }
            link.into_iter().collect()
        })
        .boxed()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(frond_testing::cases(4000)))]

    #[test]
    fn whatever_opens_is_written_and_opens_as_the_same(link in link()) {
        let (scene, _) = decode(&link);
        let written = encode(&scene).map_err(|error| TestCaseError::fail(format!("{link}: {error}")))?;
        prop_assert!(written.len() <= MAX_LINK);
        let (again, problem) = decode(&written);
        prop_assert_eq!(problem, None, "{}", written);
        prop_assert_eq!(&again, &scene, "{}", written);
        prop_assert_eq!(encode(&again), Ok(written));
    }

    #[test]
    fn whatever_space_is_unpacked_is_packed_and_unpacked_as_the_same(word in space()) {
        if let Ok(space) = unpack(&word) {
            let written = pack(&space).map_err(|error| TestCaseError::fail(format!("{word}: {error}")))?;
            let again = unpack(&written).map_err(|error| TestCaseError::fail(format!("{written}: {error}")))?;
            prop_assert_eq!(&again, &space, "{}", written);
            prop_assert_eq!(pack(&again), Ok(written));
        }
    }
}

/// The test is about links that open: most of its own do not, but of each kind many do.
#[test]
fn many_of_these_links_open() {
    use proptest::strategy::ValueTree as _;
    let mut runner = proptest::test_runner::TestRunner::deterministic();
    let (mut opened, mut curves, mut graphs, mut spaces, mut bent) = (0, 0, 0, 0, 0);
    let (mut taken, mut splines, mut words) = (0, 0, 0);
    for _ in 0..2000 {
        let Ok(tree) = link().new_tree(&mut runner) else { continue };
        let (scene, problem) = decode(&tree.current());
        let packed = scene.space.as_ref().is_some_and(|space| unpack(&space.packed).is_ok());
        opened += usize::from(problem.is_none());
        curves += usize::from(scene.curves.is_some());
        let fit = scene.fit.as_ref();
        words += usize::from(scene.curves.as_ref().is_some_and(|ends| ends.a.spline.is_some()));
        taken += usize::from(scene.curves.is_some() && fit.is_some_and(|fit| fit.curve.is_some()));
        splines += usize::from(fit.is_some_and(|fit| fit.spline.is_some()));
        graphs += usize::from(scene.directed.is_some());
        spaces += usize::from(packed);
        bent += usize::from(scene.deform.is_some());
    }
    assert!(opened > 500 && curves > 20 && spaces > 20 && bent > 30, "{opened} {curves} {spaces} {bent}");
    assert!(graphs > 20 && taken > 10 && splines > 20 && words > 5, "{graphs} {taken} {splines} {words}");
}

/// A link with `average` was given out before there was `published`: it goes on showing what it showed.
#[test]
fn averages_in_links_keep_their_meaning() {
    for (word, continuity) in [("average", Continuity::Average), ("published", Continuity::Published)] {
        let link = format!("v=1&a=gasket&b=gasket&mesh=4x4:0,0,1,1&bend=0,3,0.75&keys=0:&join={word}");
        let (scene, damage) = decode(&link);
        assert_eq!(damage, None);
        assert_eq!(scene.deform.as_ref().unwrap().continuity, continuity);
        assert!(encode(&scene).unwrap().contains(&format!("join={word}")));
    }
}
