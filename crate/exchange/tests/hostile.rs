//! Files that are made to take all memory, or all time, or to break what reads them. Each is read or refused in a few
//! times its own size.

use std::sync::{Mutex, MutexGuard, PoisonError};

use frond_exchange::{ImportError, Imported, import, link_in_png};
use peak_alloc::PeakAlloc;
use proptest::prelude::*;

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

/// Memory is counted for all threads at once: one test runs at a time.
static ALONE: Mutex<()> = Mutex::new(());

fn alone() -> MutexGuard<'static, ()> {
    ALONE.lock().unwrap_or_else(PoisonError::into_inner)
}

/// So much is needed of any file: a tree of small numbers.
const FLOOR: usize = 8 << 20;
/// Times its own size: nine letters of JSON may be an object with a list in it. Of JSON a megabyte is read.
const TIMES: usize = 90;

/// Reads a file, and holds the memory that this takes beside the file against its size.
fn read(bytes: &[u8]) -> Result<Imported, ImportError> {
    MEMORY.reset_peak_usage();
    let before = MEMORY.current_usage();
    let outcome = import(bytes);
    let taken = MEMORY.peak_usage().saturating_sub(before);
    let head = String::from_utf8_lossy(&bytes[..bytes.len().min(200)]).into_owned();
    assert!(taken <= FLOOR + TIMES * bytes.len(), "{taken} bytes for {} of {head}", bytes.len());
    match &outcome {
        Ok(found) => {
            assert!(found.systems.len() <= 1000);
            assert!(found.systems.iter().all(|system| (1..=64).contains(&system.maps.len())));
            assert!(found.systems.iter().all(|system| system.name.chars().count() <= 60));
            for system in &found.systems {
                let finite = system.maps.rows().into_iter().flatten().all(|x| x.is_finite());
                let (weights, sum) = (&system.probabilities, system.probabilities.iter().sum::<f64>());
                let sound =
                    weights.is_empty() || weights.len() == system.maps.len() && sum > 0.0 && sum.is_finite();
                assert!(finite && sound && weights.iter().all(|weight| *weight >= 0.0), "{head}: {system:?}");
            }
        }
        Err(error) => assert!(error.to_string().len() < 700, "{error}"),
    }
    outcome
}

fn code(text: &str) -> &'static str {
    read(text.as_bytes()).map_or_else(|error| error.code(), |found| found.format.id())
}

#[test]
fn large_files_of_small_things_take_little_more_than_themselves() {
    let _alone = alone();
    let fill = |one: &str, size: usize| one.repeat((size << 20) / one.len());
    for (text, told) in [
        (format!("a {{ {}", fill("1 ", 1)), "file-too-large"),
        (format!("a {{ {}", &fill("1 ", 1)[100..]), "ifs-brace"),
        (format!("a {{ {} }}", &fill("1 ", 1)[100..]), "ifs-maps"),
        (fill("{}", 1), "json-broken"),
        (fill("a{}", 1), "ifs-count"),
        (fill("a{1 2 3 4 5 6}", 1), "fractint"),
        (fill("a{", 1), "ifs-brace"),
        (fill("x", 1), "file-unknown"),
        (fill("\\frac{", 1), "file-unknown"),
        (format!("1&{}\\\\", &fill("\\frac{1}{2}&", 1)[20..]), "table-count"),
        (fill("1,5 ", 1), "table-count"),
        (fill("((((1))))*", 1), "file-unknown"),
        (format!("a {{{}}}", &fill("1,5 ", 1)[10..]), "ifs-count"),
        (fill("1\n", 1), "table-count"),
        (fill("1 2 3 4 5 6\n", 1), "table-maps"),
        (fill("[", 1), "json-broken"),
        (format!("[{}0]", &fill("0,", 1)[8..]), "json-nothing"),
        (format!("[{}[]]", &fill("[],", 1)[9..]), "json-maps"),
        (format!("[{}{{}}]", &fill("{\"a\":[]},", 1)[18..]), "json-nothing"),
        (fill("@\nA=A\n", 2), "ifstile"),
        (format!("@\nA={}", &fill("(", 2)[8..]), "aifs-nothing"),
        (format!("@\nA={}A", &fill("-", 2)[8..]), "aifs-unread"),
        (format!("@\nA={}A", &fill("1*", 2)[8..]), "aifs-unread"),
        (format!("@\nA={}A", &fill("2^", 2)[8..]), "aifs-unread"),
        (fill("<flame>", 8), "flame-not-affine"),
        (format!("<flames>{}</flames>", &fill("<flame/>", 8)[40..]), "flame-not-affine"),
        (format!("<flame>{}</flame>", &fill("<xform/>", 8)[40..]), "flame-maps"),
        (format!("<flame {}/>", &fill("a='1' ", 8)[60..]), "flame-not-affine"),
        (
            format!("<flame><xform coefs='.5 0 0 .5 0 0' {}/></flame>", &fill("a_b='1' ", 8)[80..]),
            "flame-not-affine",
        ),
        (format!("<flame name='{}'/>", &fill("&amp;", 8)[60..]), "flame-not-affine"),
        (format!("<flame><xform coefs='{}'/></flame>", &fill("1 ", 8)[60..]), "flame-number"),
    ] {
        let head: String = text.chars().take(60).collect();
        assert_eq!(code(&text), told, "{head}");
    }
}

#[test]
fn names_that_call_each_other_end() {
    let _alone = alone();
    // Each name is twice the one before: without a count of steps this takes for ever.
    let names: String = (1..60).map(|k| format!("n{k}=n{}*n{}\n", k - 1, k - 1)).collect();
    assert_eq!(code(&format!("@\nn0=2\n{names}A=n30*A\n")), "aifs-unread");
    let blocks: String = (1..5000).map(|k| format!("@b{k}:b{}\n", k - 1)).collect();
    assert_eq!(code(&format!("@b0\nf=2^-1\nA=f*A\n{blocks}")), "ifstile");
    assert_eq!(code("@a:a\n$dim=2\nA=2^-1*A\n"), "ifstile");
}

#[test]
fn what_one_line_says_is_not_looked_at_for_each_thing_anew() {
    let _alone = alone();
    let fill = |one: &str, size: usize| one.repeat(size / one.len());
    // A thousand wrong flames, whose lines are counted; keys with many places where a name may end.
    let blanks = fill(" ", 8000);
    let flames = fill(&format!("<flame><xform coefs='x'/>{blanks}</flame>\n"), (8 << 20) - 100);
    assert_eq!(code(&flames), "flame-number");
    let keys = fill(&format!("{}='1' ", fill("_", 40_000)), (8 << 20) - 100);
    assert_eq!(code(&format!("<flame><xform {keys}/></flame>")), "flame-not-affine");
    let words = fill(&format!("{}='x' ", fill("_", 90)), (8 << 20) - 100);
    assert_eq!(code(&format!("<flame><xform weight='0' {words}/></flame>")), "flame-not-affine");
    let commas = fill("0,5 ", (8 << 20) - 100);
    assert_eq!(code(&format!("<flame><xform coefs='{commas}'/></flame>")), "flame-number");
    assert_eq!(code(&format!("<flame><xform weight='{commas}'/></flame>")), "flame-number");
    let groups = fill("<variationGroup a='1' b_c='1'/>", (8 << 20) - 100);
    assert_eq!(code(&format!("<flame><xform>{groups}</xform></flame>")), "flame-not-affine");
    // Many braces before one long remark.
    assert_eq!(code(&format!("a{};{}", fill("{}", 1 << 19), fill("x", (1 << 19) - 9))), "ifs-count");
    // Thousands of blocks that have all of one large block: its names, a long value named often, its own name.
    let blocks = fill("@:b\n", 16_000);
    let names: String = (0..80_000).map(|k| format!("x{k}=1\n")).collect();
    assert_eq!(code(&format!("@b\n$a=h\n{names}{blocks}")), "aifs-nothing");
    let sets: String = (0..60_000).map(|k| format!("x{k}=x{k}\n")).collect();
    assert_eq!(code(&format!("@b\n$a=h\n{sets}{blocks}")), "ifstile");
    let blanks = fill(" ", 1 << 20);
    let often = vec!["x"; 5000].join("+");
    assert_eq!(code(&format!("@b\n$a=h\nx=1{blanks}+1\nA=({often})*A\n{blocks}")), "ifstile");
    assert_eq!(code(&format!("@b\n$a=h\n$n=a{blanks}b\nA=[.5,0,0,.5]*A\n{blocks}")), "ifstile");
    let found = read(format!("@b\n$a=h\n$n=a{blanks}b\nA=[.5,0,0,.5]*A\n{blocks}").as_bytes()).unwrap();
    assert!(found.remarks.iter().any(|remark| remark.contains("too many steps")), "{:?}", found.remarks);
}

/// Numbers at the ends of what can be written, and ordinary ones.
fn number() -> impl Strategy<Value = String> {
    let odd = [
        "0",
        "-0",
        "5e-324",
        "1e300",
        "-1.7976931348623157e308",
        "1e309",
        "nan",
        "inf",
        "1e",
        ".",
        "-",
        "+",
        "1,5",
        "0x10",
        "1/3",
        "3.0000000000000004",
        "99999999999999999999",
        "",
    ];
    prop_oneof![
        2 => proptest::sample::select(odd.to_vec()).prop_map(String::from),
        3 => (-50..50_i32).prop_map(|value| value.to_string()),
        3 => (-1.0..1.0).prop_map(|value: f64| value.to_string()),
    ]
}

fn numbers() -> impl Strategy<Value = String> {
    let separator = proptest::sample::select(vec![" ", ",", ", ", "\t", ";", "\r\n", "\n"]);
    (proptest::collection::vec(number(), 0..15), separator).prop_map(|(list, by)| list.join(by))
}

fn fractint() -> impl Strategy<Value = String> {
    let odd =
        prop_oneof![Just("{"), Just("}"), Just(";"), Just("(3D)"), Just("comment"), Just("\n"), Just("é {")];
    let entry = ("[a-z ]{0,6}", any::<bool>(), proptest::collection::vec(numbers(), 0..4)).prop_map(
        |(name, solid, rows)| {
            format!("{name}{} {{\n{}\n}}\n", if solid { "(3d)" } else { "" }, rows.join("\n"))
        },
    );
    proptest::collection::vec(prop_oneof![5 => entry, 1 => odd.prop_map(String::from)], 0..6)
        .prop_map(|list| list.concat())
}

fn flame() -> impl Strategy<Value = String> {
    let key = proptest::sample::select(vec![
        "weight",
        "linear",
        "linear3D",
        "coefs",
        "post",
        "julian",
        "julian_power",
        "var",
        "var1",
        "chaos",
        "name",
        "x:y",
        "yzCoefs",
        "zxPost",
        "ztranslate",
        "pre_zscale",
        "opacity",
        "enabled",
        "jwf_julian#1#",
        "#",
    ]);
    let attribute = (key, prop_oneof![numbers(), Just("&lt;&bad;".to_owned())])
        .prop_map(|(key, value)| format!("{key}=\"{value}\""));
    let tag = proptest::sample::select(vec![
        "xform",
        "finalxform",
        "flame",
        "color",
        "symmetry",
        "motion",
        "variationGroup",
    ]);
    let element = (tag, proptest::collection::vec(attribute, 0..6), any::<bool>())
        .prop_map(|(tag, list, open)| format!("<{tag} {}{}>", list.join(" "), if open { "" } else { "/" }));
    let odd = prop_oneof![
        Just("</flame>"),
        Just("<!--"),
        Just("-->"),
        Just("<![CDATA["),
        Just("&"),
        Just("<!DOCTYPE a [<!ENTITY x '&x;'>]>")
    ];
    proptest::collection::vec(prop_oneof![5 => element, 1 => odd.prop_map(String::from)], 0..8)
        .prop_map(|list| format!("<flame>{}</flame>", list.concat()))
}

fn ifstile() -> impl Strategy<Value = String> {
    let part = prop_oneof![
        number(),
        proptest::sample::select(vec!["A", "B", "f", "$i", "$pi", "$dim", "&x", "sin", "é"])
            .prop_map(String::from),
        proptest::sample::select(vec!["+", "-", "*", "/", "^", "|", "(", ")", "[", "]", ",", " "])
            .prop_map(String::from),
        Just("[.5,0,0,.5]".to_owned()),
        Just("(f|A)".to_owned()),
    ];
    let line = (
        proptest::sample::select(vec!["A=", "B=", "f=", "$dim=", "@x:x", "@:y", "@@", "$n="]),
        proptest::collection::vec(part, 0..10),
    )
        .prop_map(|(start, parts)| format!("{start}{}\n", parts.concat()));
    proptest::collection::vec(line, 0..10).prop_map(|lines| format!("@\n{}", lines.concat()))
}

fn json() -> impl Strategy<Value = String> {
    let leaf = prop_oneof![
        number(),
        Just("null".to_owned()),
        Just("\"maps\"".to_owned()),
        numbers().prop_map(|list| format!("[{}]", list.replace([' ', '\t', ';'], ","))),
    ];
    leaf.prop_recursive(5, 40, 6, |inner| {
        let key =
            proptest::sample::select(vec!["maps", "systems", "name", "probabilities", "a", "b", "path"]);
        prop_oneof![
            proptest::collection::vec(inner.clone(), 0..6).prop_map(|list| format!("[{}]", list.join(","))),
            proptest::collection::vec((key, inner), 0..6).prop_map(|list| {
                let fields: Vec<String> =
                    list.into_iter().map(|(key, value)| format!("\"{key}\":{value}")).collect();
                format!("{{{}}}", fields.join(","))
            }),
        ]
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(frond_testing::cases(600)))]

    #[test]
    fn no_text_breaks_what_reads_it(text in prop_oneof![fractint(), flame(), ifstile(), json(), numbers()]) {
        let _alone = alone();
        let _ = read(text.as_bytes());
    }

    #[test]
    fn no_bytes_break_what_reads_them(mut bytes in proptest::collection::vec(any::<u8>(), 0..400), start in 0..6_usize) {
        let _alone = alone();
        let starts: [&[u8]; 6] = [b"", b"\x89PNG\r\n\x1a\n\0\0\0\x04iTXt", b"\xff\xfe", b"a {", b"<flame ", b"{\""];
        bytes.splice(0..0, starts[start].iter().copied());
        let _ = read(&bytes);
        let _ = link_in_png(&bytes);
    }

    #[test]
    fn a_cut_or_changed_file_breaks_nothing(text in prop_oneof![fractint(), flame(), ifstile(), json()], at in any::<prop::sample::Index>(), byte in any::<u8>()) {
        let _alone = alone();
        let mut bytes = text.into_bytes();
        let at = at.index(bytes.len().max(1));
        let _ = read(&bytes[..at.min(bytes.len())]);
        if let Some(changed) = bytes.get_mut(at) {
            *changed = byte;
        }
        let _ = read(&bytes);
    }
}
