//! Files that are made to take all memory, or all time: small ones that are large once they are drawn, and large ones
//! of very small things. Each is read or refused in a few times its own size.

use std::sync::{Mutex, MutexGuard, PoisonError};

use frond_fit::{FileContent, MAX_OUTLINE, ReadAs, ReadError, read_file};
use peak_alloc::PeakAlloc;
use proptest::prelude::*;

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

/// Memory is counted for all threads at once: one test runs at a time.
static ALONE: Mutex<()> = Mutex::new(());

fn alone() -> MutexGuard<'static, ()> {
    ALONE.lock().unwrap_or_else(PoisonError::into_inner)
}

/// So much is needed of any file: a line of a million points, as it grows.
const FLOOR: usize = 40 << 20;

type Outcome = Result<FileContent, ReadError>;

/// Reads a file, and holds the memory that this takes beside the file against its size.
fn read(bytes: &[u8]) -> Outcome {
    MEMORY.reset_peak_usage();
    let before = MEMORY.current_usage();
    let outcome = read_file(bytes, ReadAs::Guess);
    let taken = MEMORY.peak_usage().saturating_sub(before);
    let head = String::from_utf8_lossy(&bytes[..bytes.len().min(300)]).into_owned();
    assert!(taken <= FLOOR + 3 * bytes.len(), "{taken} bytes for {} of {head}", bytes.len());
    outcome
}

fn code(outcome: &Outcome) -> &'static str {
    match outcome {
        Ok(FileContent::Outlines { format, .. }) => format,
        Ok(FileContent::Series { .. }) => "series",
        Err(error) => error.code(),
    }
}

/// How many points all outlines have, none of them too many.
fn points(outcome: &Outcome) -> usize {
    let Ok(FileContent::Outlines { outlines, .. }) = outcome else { return 0 };
    assert!(outlines.len() <= 100);
    let counts = || outlines.iter().map(|one| one.outline.points().len());
    assert!(counts().all(|count| count <= MAX_OUTLINE));
    counts().sum()
}

fn svg(inside: &str) -> String {
    format!("<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 80'>{inside}</svg>")
}

#[test]
fn shapes_have_few_points_however_small_or_large_they_are() {
    let _alone = alone();
    for (shape, told) in [
        ("<ellipse rx='1e-300' ry='3'/>", "nothing"),
        ("<ellipse rx='1e-9' ry='3'/>", "svg"),
        ("<rect width='4' height='3' rx='5e-324'/>", "svg"),
        ("<rect width='4' height='3' rx='1e-300' ry='1'/>", "svg"),
        ("<circle r='5e-324'/>", "nothing"),
        ("<circle r='1e-100'/>", "nothing"),
        ("<circle r='1e9'/>", "svg"),
        ("<path d='M0 0a5e82 2 3 0 1 2 1z'/>", "nothing"),
        ("<path d='M0 0a1e-300 2 3 1 1 2 1z'/>", "too-few-points"),
        ("<path d='M0 0a5 5e-324 1e300 1 0 2 1h1v3z'/>", "svg"),
        ("<path transform='scale(1e300)scale(1e300)' d='M0 0h1v1z'/>", "nothing"),
        // As browsers do, a transform that is miswritten is left out.
        ("<path transform='scale(nan)' d='M0 0h1v1z'/>", "svg"),
        ("<path transform='matrix(1e-300 0 0 1e300 0 0)' d='M0 0C1 2 3 4 5 6z'/>", "nothing"),
        ("<polygon points='nan,0 inf,1 1e999,3 2,2'/>", "nothing"),
        // What is far away says how finely the rest is seen.
        ("<circle r='1e-300'/><circle cx='5' r='3'/>", "svg"),
    ] {
        let outcome = read(svg(shape).as_bytes());
        assert_eq!(code(&outcome), told, "{shape}");
        assert!(points(&outcome) < 1000, "{shape}: {}", points(&outcome));
    }
}

#[test]
fn many_uses_and_attributes_take_no_more_time_than_they_are_long() {
    let _alone = alone();
    let many = |count: usize, one: &dyn Fn(usize) -> String| (0..count).map(one).collect::<String>();
    let defined = many(22_000, &|i| format!("<path id='p{i}' d='M0 0h1v1z'/>"));
    let used = |count| many(count, &|i| format!("<use href='#p{}' x='{i}'/>", 21_999 - i % 100));
    let drawing = |count| svg(&format!("<defs>{defined}</defs>{}", used(count)));
    assert_eq!(code(&read(drawing(9_000).as_bytes())), "svg");
    assert_eq!(code(&read(drawing(15_000).as_bytes())), "too-many");
    let list = many(100_000, &|i| format!(" a{i}='1'"));
    assert_eq!(code(&read(svg(&format!("<path d='M0 0h9v9h-9z'{list}/>")).as_bytes())), "too-many");
    let prefixes = many(20_000, &|i| format!(" xmlns:a{i}='u{i}'"));
    let children = many(5_000, &|i| format!("<g xmlns:b{i}='v'/>"));
    assert_eq!(code(&read(svg(&format!("<g{prefixes}>{children}</g>")).as_bytes())), "too-many");
}

#[test]
fn what_is_used_again_and_again_is_refused() {
    let _alone = alone();
    let path = |turns: usize| format!("<path id='p' d='M0 0{}'/>", "h1v1".repeat(turns));
    for (inside, told) in [
        (path(200_000) + &"<use href='#p'/>".repeat(15_000), "too-many"),
        (path(10) + &"<use href='#p'/>".repeat(9_000), "svg"),
        (
            format!("<g id='a'><use href='#a'/>{}</g>", "<rect width='1' height='2'/>".repeat(190_000)),
            "too-many",
        ),
        // What uses itself is drawn once.
        (format!("<g id='a'><use href='#a'/><use href='#a'/>{}</g>", path(3)), "svg"),
        (
            "<g id='a'><use href='#b'/><use href='#b'/></g><g id='b'><use href='#a'/><use href='#a'/></g>"
                .into(),
            "nothing",
        ),
    ] {
        assert_eq!(code(&read(svg(&inside).as_bytes())), told, "{}", &inside[..60]);
    }
}

#[test]
fn large_files_of_small_things_take_little_more_than_themselves() {
    let _alone = alone();
    const SIZE: usize = 4 << 20;
    let fill = |one: &str| one.repeat(SIZE / one.len());
    let path = |d: &str| svg(&format!("<path d='M0 0{}'/>", fill(d)));
    let json = |list: &str| format!("{{\"type\":\"FeatureCollection\",\"features\":[{list}null]}}");
    let lines = |list: &str| format!("{{\"type\":\"MultiLineString\",\"coordinates\":[{list}[]]}}");
    let feature = |ring: &str| format!("{{\"geometry\":{{\"coordinates\":[{ring}],\"type\":\"Polygon\"}}}},");
    let topology = |arcs: &str, of: &str| {
        format!(
            "{{\"type\":\"Topology\",\"arcs\":[{arcs}[]],\"objects\":{{\"a\":{{\"type\":\"Polygon\",\"arcs\":{of}}}}}}}"
        )
    };
    let drawn = |list: &str| format!("{{\"images\":[],\"annotations\":[{list}null]}}");
    let ring = format!("[[0,0]{}]", ",[3.125,4.5]".repeat(100));
    for (text, told) in [
        (path("z"), "nothing"),
        (path("h1v1"), "too-many"),
        (path("M0 0h1"), "too-few-points"),
        (path("M0 0h1v1h-1"), "svg"),
        (path("C9 9 0 9 1 0C-9-9 0-9-1 0"), "too-many"),
        (path("a1 1 0 1 1 1 0"), "too-many"),
        (path("a0.5,0.125 10 1 1 0.25,0.5 "), "svg"),
        (svg(&fill("<g/>")), "too-many"),
        (svg(&fill("<g>")), "too-many"),
        (svg(&format!("<path {}/>", fill("a='' "))), "too-many"),
        (svg(&format!("<path id='{}' d='M0 0h1v1h-1z'/>", fill("&amp;"))), "svg"),
        (svg(&format!("<path transform='matrix({})' d='M0 0h1v1h-1z'/>", fill("1 "))), "svg"),
        (svg(&format!("<text>{}</text><path d='M0 0h1v1h-1z'/>", fill("a&b;<![CDATA[x]]>"))), "svg"),
        (format!("<{0}></{0}x>", fill("svg")), "broken"),
        (json(&fill("{},")), "nothing"),
        (json(&fill("{\"properties\":{\"name\":\"a\"}},")), "nothing"),
        (json(&fill(&feature(&ring))), "flat"),
        (json(&fill(&feature("[[0,0],[9,0],[9,9],[0,9]]"))), "geojson"),
        (lines(&fill("[[0,0],[999,0],[999,9],[0,9]],")), "geojson"),
        (lines(&format!("[{}[5,6]],", fill("[1,2],"))), "flat"),
        (lines(&fill("[],")), "nothing"),
        (lines(&fill("1,")), "nothing"),
        (fill("["), "broken"),
        (format!("{{\"x\":{}", fill("[")), "broken"),
        (fill("{\"geometry\":"), "broken"),
        (format!("{{\"type\":\"{}\"}}", fill("\\n")), "nothing"),
        (format!("{{\"coordinates\":\"{}\"}}", fill("x")), "broken"),
        (topology(&fill("[[0,0],[9,0],[9,9],[0,8]],"), "[[0]]"), "geojson"),
        (topology(&fill("[],"), "[[0]]"), "too-many"),
        (topology(&fill("[[1,2],[3,4],[5,6],[7,8],[9,1],[1,1]],")[..1 << 20], "[[0]]"), "broken"),
        (topology("[[0,0],[9,0],[9,9],[0,8]],", &format!("[{}[0]]", fill("[0],"))), "geojson"),
        (
            topology(&format!("[{}[0,8]],", "[0,0],[9,0],".repeat(9_000)), &format!("[{}[0]]", fill("[0],"))),
            "broken",
        ),
        (drawn(&fill("{\"segmentation\":[[0,0,9,0,9,9,0,8]],\"category_id\":1},")), "geojson"),
        (drawn(&format!("{{\"segmentation\":[[{}0,0]]}},", fill("1,"))), "flat"),
        (drawn(&fill("{\"segmentation\":{\"counts\":[1,2]}},")), "nothing"),
        (format!("{{\"x\":[{0}0],\"y\":[{0}0]}}", fill("1,")), "flat"),
        (format!("[{}{{}}]", fill("{\"x\":1,\"y\":2},")), "flat"),
        (format!("[{}0]", fill("{\"a\":{},\"b\":[]},")), "nothing"),
        (fill("1\n"), "series"),
        (fill("1,23;4,56\n"), "flat"),
        (fill("1 "), "series"),
        (fill("\"1,"), "no-numbers"),
        (fill("1"), "no-numbers"),
        (fill("0 0\n9 0\n9 9\n0 9\n0 0\n\n"), "csv"),
        (fill("a\n0 0\n9 0\n9 9\n0 9\n"), "csv"),
        (fill("a,0,0\na,9,0\na,9,9\na,0,9\nb,0,0\nb,9,0\nb,9,9\nb,0,8\n"), "csv"),
        (fill("1,0,0\n1,9,0\n1,9,9\n1,0,9\n"), "csv"),
        (fill("LM=4\n0 0\n9 0\n9 9\n0 9\nID=1\n"), "csv"),
        (fill("LM=1\n"), "too-few-points"),
        (format!("LM=0\n{}", fill("POINTS=4\n0 0\n9 0\n9 9\n0 9\n")), "csv"),
        (format!("LM=0\n{}", fill("POINTS=2\n0 0\n9 0\n")), "too-few-points"),
        (format!("LM=0\n{}", fill("x\n")), "too-few-points"),
    ] {
        let outcome = read(text.as_bytes());
        let head: String = text.chars().take(90).collect();
        assert_eq!(code(&outcome), told, "{head}");
        points(&outcome);
    }
    // Bytes that are no text take three times their room.
    let mut bytes = b"1,2\n".to_vec();
    bytes.resize(SIZE, 0xff);
    assert_eq!(code(&read(&bytes)), "no-numbers");
    let wide = svg(&format!("<text>{}</text><path d='M0 0h1v1h-1z'/>", "字".repeat(SIZE / 2)));
    let wide: Vec<u8> =
        std::iter::once(0xfeff).chain(wide.encode_utf16()).flat_map(u16::to_le_bytes).collect();
    assert_eq!(code(&read(&wide)), "svg");
}

/// Numbers at the ends of what can be written, and ordinary ones.
fn number() -> impl Strategy<Value = String> {
    let odd = [
        "0",
        "-0",
        "5e-324",
        "1e-300",
        "-1e-160",
        "1e-12",
        "1e-5",
        "1e5",
        "1e9",
        "-999999999",
        "5e82",
        "1e155",
        "1e300",
        "-1.7976931348623157e308",
        "1e309",
        "nan",
        "inf",
        "1e",
        ".",
        "3.0000000000000004",
    ];
    prop_oneof![
        2 => proptest::sample::select(odd.to_vec()).prop_map(String::from),
        3 => (-50..50_i32).prop_map(|value| value.to_string()),
        1 => (-1.0..1.0).prop_map(|value: f64| value.to_string()),
    ]
}

fn numbers(count: usize) -> impl Strategy<Value = String> {
    proptest::collection::vec(number(), count).prop_map(|list| list.join(" "))
}

fn path() -> impl Strategy<Value = String> {
    let command = prop_oneof![
        ("[MLmlTt]", numbers(2)),
        ("[HhVv]", numbers(1)),
        ("[QqSs]", numbers(4)),
        ("[Cc]", numbers(6)),
        ("[Zz]", numbers(0)),
        (
            "[Aa]",
            (numbers(3), "[01] [01]", numbers(2))
                .prop_map(|(radii, flags, to)| format!("{radii} {flags} {to}"))
        ),
    ];
    let command = command.prop_map(|(letter, numbers)| letter + &numbers);
    (proptest::collection::vec(command, 1..12), 1..30_usize)
        .prop_map(|(list, times)| format!("M0 0{}", list.concat().repeat(times)))
}

fn transform() -> impl Strategy<Value = String> {
    prop_oneof![
        3 => Just(String::new()),
        1 => numbers(6).prop_map(|list| format!("matrix({list})")),
        1 => (numbers(2), numbers(2)).prop_map(|(to, by)| format!("translate({to}) scale({by})")),
        1 => (numbers(3), number()).prop_map(|(turn, skew)| format!("rotate({turn})skewX({skew})")),
    ]
}

fn element() -> impl Strategy<Value = String> {
    let size = || proptest::collection::vec(number(), 6);
    let shape = prop_oneof![
        path().prop_map(|d| format!("path d='{d}'")),
        (0..40_usize).prop_flat_map(numbers).prop_map(|list| format!("polygon points='{list}'")),
        size().prop_map(|n| format!(
            "rect x='{}' y='{}' width='{}' height='{}' rx='{}' ry='{}'",
            n[0], n[1], n[2], n[3], n[4], n[5]
        )),
        size().prop_map(|n| format!("circle cx='{}' cy='{}' r='{}'", n[0], n[1], n[2])),
        size().prop_map(|n| format!("ellipse cx='{}' cy='{}' rx='{}' ry='{}'", n[0], n[1], n[2], n[3])),
        (0..8, number()).prop_map(|(id, x)| format!("use href='#i{id}' x='{x}'")),
    ];
    (shape, transform(), 0..8, look()).prop_map(|(shape, transform, id, look)| {
        format!("<{shape} id='i{id}' class='c{id}' transform='{transform}'{look}/>")
    })
}

/// What clips, hides or moves an element.
fn look() -> impl Strategy<Value = String> {
    let length = || (number(), proptest::sample::select(vec!["", "px", "%", "em", "mm"]));
    prop_oneof![
        6 => Just(String::new()),
        2 => (0..8).prop_map(|id| format!(" clip-path='url(#i{id})'")),
        1 => (0..8).prop_map(|id| format!(" mask='url(#i{id})'")),
        1 => Just(" visibility='hidden'".into()),
        1 => (number(), number()).prop_map(|(x, turn)| format!(
            " style='transform:translate({x}px,5%) rotate({turn}deg);transform-box:fill-box;transform-origin:center'"
        )),
        1 => (length(), length()).prop_map(|((x, a), (r, b))| format!(
            " style='cx:{x}{a};r:{r}{b};width:{r}{b};fill-rule:evenodd;scale:{x}'"
        )),
        1 => numbers(4).prop_map(|sides| format!(" viewBox='{sides}' preserveAspectRatio='xMidYMid slice'")),
    ]
}

fn drawing() -> impl Strategy<Value = String> {
    let group = |inner: BoxedStrategy<String>| {
        let name = proptest::sample::select(vec![
            "g", "g", "g", "symbol", "defs", "svg", "clipPath", "mask", "pattern",
        ]);
        (name, 0..8, transform(), look(), proptest::collection::vec(inner, 1..5)).prop_map(
            |(name, id, transform, look, inner)| {
                format!("<{name} id='i{id}' transform='{transform}'{look}>{}</{name}>", inner.concat())
            },
        )
    };
    element().prop_recursive(4, 40, 5, move |inner| group(inner.boxed()))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(frond_testing::cases(400)))]

    #[test]
    fn no_drawing_takes_much_memory_or_has_many_points(
        list in proptest::collection::vec(drawing(), 1..6),
        rule in look(),
    ) {
        let _alone = alone();
        let rule = rule.trim_start_matches(" style='").trim_end_matches('\'').to_owned();
        let text = svg(&format!("<style>.c1{{{rule}}}</style>{}", list.concat()));
        let outcome = read(text.as_bytes());
        if let Err(error) = &outcome {
            let told = ["nothing", "flat", "too-few-points", "too-many", "broken"].contains(&error.code());
            prop_assert!(told, "{error:?}: {text}");
        }
        // Two letters may draw a curve, and it has some hundred sides at most; few elements use all others.
        prop_assert!(points(&outcome) <= 20 * MAX_OUTLINE);
        if !text.contains("<use") {
            prop_assert!(points(&outcome) <= 400 * text.len(), "{text}");
        }
    }
}
