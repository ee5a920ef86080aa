//! Good files that were cut, changed, written by another machine, or made too large: what is read of them is right or
//! said, and what is not read is told with its line.

use frond_exchange::{ExportFormat, ImportError, Imported, System, export, import, png_with_link};

const READ: [ExportFormat; 4] =
    [ExportFormat::Json, ExportFormat::Fractint, ExportFormat::Flame, ExportFormat::Csv];

fn system(count: usize) -> System {
    let row = |k: usize| [0.5, -0.25, 1.0 / 3.0, 0.5, k as f64, -0.125];
    let mut system = System::plane("Fougère & co".into(), (0..count).map(row).collect());
    system.probabilities = (0..count).map(|k| 0.25 + k as f64).collect();
    system
}

/// A file of IFStile with so many maps.
fn tile(count: usize) -> String {
    let maps: Vec<String> = (0..count).map(|k| format!("[{k},0]*[.5,0,0,.5]")).collect();
    format!("@\n$dim=2\n$n=Fougère\nA=({})*A\n", maps.join("|"))
}

/// A file of each kind of text.
fn texts() -> Vec<(&'static str, String)> {
    let mut texts: Vec<_> =
        READ.iter().map(|&format| (format.id(), export(&system(3), format).unwrap())).collect();
    texts.push(("ifstile", tile(3)));
    texts
}

fn picture() -> Vec<u8> {
    let head = b"\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR\0\0\0\x01\0\0\0\x01\x08\0\0\0\0\x3a\x7e\x9b\x55\0\0\0\0IEND\xae\x42\x60\x82";
    png_with_link(head, "https://example.org/#v=1&a=fern").unwrap()
}

/// Reads what may be damaged. Whatever is wrong is told in a sentence or two, with its line where there are any.
fn read(bytes: &[u8]) -> Result<Imported, ImportError> {
    let outcome = import(bytes);
    if let Err(error) = &outcome {
        let (code, told) = (error.code(), error.to_string());
        assert!(told.len() < 700 && told.ends_with(['.', '}', '>']), "{told}");
        assert!(!told.contains(char::is_control), "{told:?}");
        let whole = code.starts_with("file-")
            || code.ends_with("-nothing")
            || ["ifs-empty", "json-map", "json-maps", "json-document"].contains(&code);
        let line = ["Line ", "at line "]
            .iter()
            .find_map(|start| told.split_once(start)?.1.split(|c: char| !c.is_ascii_digit()).next());
        let lines = 1 + bytes.iter().filter(|&&byte| matches!(byte, b'\n' | b'\r')).count();
        let known = line.and_then(|line| line.parse::<usize>().ok()).is_some_and(|line| line <= lines);
        assert!(whole || known, "{code}: {told}");
    }
    outcome
}

fn code(text: &str) -> &'static str {
    read(text.as_bytes()).map_or_else(|error| error.code(), |found| found.format.id())
}

#[test]
fn a_file_that_is_cut_is_refused_or_says_what_is_missing() {
    for (kind, text) in texts() {
        let whole = read(text.as_bytes()).unwrap();
        let end = text.trim_end().len();
        for at in 0..end {
            // A table may end with any line, or within its last number; so may names and numbers of a script.
            let told = match read(&text.as_bytes()[..at]) {
                Err(_) => true,
                Ok(found) if kind == "flame" => found == whole || !found.systems[0].remarks.is_empty(),
                Ok(_) => matches!(kind, "csv" | "ifstile"),
            };
            assert!(told, "{kind}, cut at {at}: {}", String::from_utf8_lossy(&text.as_bytes()[..at]));
        }
    }
    let picture = picture();
    let link = import(&picture).unwrap().link;
    assert_eq!(link.as_deref(), Some("v=1&a=fern"));
    for at in 0..picture.len() {
        assert!(read(&picture[..at]).map_or(true, |found| found.link == link), "{at}");
    }
}

#[test]
fn a_bit_that_is_changed_breaks_nothing() {
    let files = texts().into_iter().map(|(_, text)| text.into_bytes()).chain([picture()]);
    for mut bytes in files {
        for at in 0..8 * bytes.len() {
            bytes[at / 8] ^= 1 << (at % 8);
            if let Ok(found) = read(&bytes) {
                assert!(
                    found.systems.iter().all(|system| system
                        .maps
                        .rows()
                        .into_iter()
                        .flatten()
                        .all(|x| x.is_finite()))
                );
            }
            bytes[at / 8] ^= 1 << (at % 8);
        }
    }
}

#[test]
fn chunks_that_lie_about_their_length_hold_no_link() {
    let picture = picture();
    let at = picture.windows(4).position(|kind| kind == b"iTXt").unwrap();
    for length in [0, 1, 11, 0x7fff_ffff, 0xffff_fff3, u32::MAX] {
        let mut bytes = picture.clone();
        bytes[at - 4..at].copy_from_slice(&u32::to_be_bytes(length));
        assert_eq!(read(&bytes).unwrap_err().code(), "file-no-link", "{length}");
    }
    // A compressed one is not unpacked: it may grow without end.
    let mut bytes = picture;
    bytes[at + 4 + "Frond link\0".len()] = 1;
    assert_eq!(read(&bytes).unwrap_err().code(), "file-no-link");
}

#[test]
fn a_link_is_found_behind_large_chunks() {
    let picture = picture();
    let at = picture.windows(4).position(|kind| kind == b"iTXt").unwrap() - 4;
    let mut large = u32::to_be_bytes(3 << 20).to_vec();
    large.extend(b"IDAT");
    large.resize(12 + (3 << 20), 0);
    let bytes = [&picture[..at], &large, &picture[at..]].concat();
    assert_eq!(read(&bytes).unwrap().link.as_deref(), Some("v=1&a=fern"));
}

#[test]
fn weights_that_say_nothing_are_left_out() {
    let found = |text: &str| read(text.as_bytes()).unwrap().systems.remove(0);
    // Without their sign; and not at all, where they are all zero or have no sum. Each is said.
    let (negative, zero, large) = ("negative: taken without the sign.", "all 0.", "their sum is not finite.");
    for (weights, wanted, said) in [
        (["-0.25", "0.5"], &[0.25, 0.5][..], &[negative][..]),
        (["-1", "-2"], &[1.0, 2.0], &[negative]),
        (["0", "0"], &[], &[zero]),
        (["0", "5e-324"], &[0.0, 5e-324], &[]),
        (["1e308", "1e308"], &[], &[large]),
        (["1e308", "-1e308"], &[], &[negative, large]),
    ] {
        let [one, other] = weights;
        for text in [
            format!("a {{\n.5 0 0 .5 0 0 {one}\n.5 0 0 .5 1 0 {other}\n}}"),
            format!(".5 0 0 .5 0 0 {one}\n.5 0 0 .5 1 0 {other}\n"),
            format!("{{\"maps\": [[0,0,0,0,0,0],[0,0,0,0,1,0]], \"probabilities\": [{one}, {other}]}}"),
        ] {
            let system = found(&text);
            assert_eq!(system.probabilities, wanted, "{text}");
            assert_eq!(system.remarks.len(), said.len(), "{:?}", system.remarks);
            assert!(system.remarks.iter().zip(said).all(|(told, part)| told.contains(part)), "{text}");
        }
    }
    for weights in ["[1]", "[1,2,3]", "[1,null]", "{}"] {
        let system =
            found(&format!("{{\"maps\": [[0,0,0,0,0,0],[0,0,0,0,1,0]], \"probabilities\": {weights}}}"));
        assert_eq!((system.probabilities.len(), system.remarks.len()), (0, 1), "{weights}");
    }
    // Where some maps have one and others have none, none is handed to another map.
    for (text, without) in [
        ("a {\n.5 0 0 .5 0 0 .7\n.5 0 0 .5 1 0\n.5 0 0 .5 2 0 .2\n}", 2),
        (".5 0 0 .5 0 0\n.5 0 0 .5 1 0 .2\n", 1),
        ("<flame><xform weight='2' coefs='.5 0 0 .5 0 0'/><xform coefs='.5 0 0 .5 1 0'/></flame>", 2),
    ] {
        let system = found(text);
        assert_eq!(system.probabilities, [0.0; 0], "{text}");
        assert!(
            system.remarks[0].starts_with(&format!("Map {without} has no weight")),
            "{:?}",
            system.remarks
        );
    }
    // Written, they are what each map leaves of areas.
    let mut system = system(2);
    system.probabilities = vec![0.0, 0.0];
    for format in READ.into_iter().filter(|format| *format != ExportFormat::Json) {
        let weights = found(&export(&system, format).unwrap()).probabilities;
        assert!(weights.len() == 2 && weights.iter().all(|weight| *weight > 0.0), "{format:?}: {weights:?}");
    }
}

#[test]
fn many_maps_take_as_many_steps() {
    let list = |count: usize| (0..count).map(|k| format!("[{k},0]")).collect::<Vec<_>>().join("|");
    let file = |count: usize| format!("@\nf={0}\nA=.5*(f)*f{1}*A\n", list(8), "*1".repeat(count));
    assert_eq!(code(&file(100)), "ifstile");
    // Each of these is 64 products.
    assert_eq!(code(&file(50_000)), "aifs-unread");
}

#[test]
fn the_same_text_of_any_machine_is_the_same() {
    for (kind, text) in texts() {
        let wanted = read(text.as_bytes()).unwrap();
        let units: Vec<u16> = text.encode_utf16().collect();
        let wide = |mark: [u8; 2], unit: fn(u16) -> [u8; 2]| {
            mark.into_iter().chain(units.iter().flat_map(|&x| unit(x))).collect::<Vec<u8>>()
        };
        for bytes in [
            format!("\u{feff}{text}").into_bytes(),
            wide([0xff, 0xfe], u16::to_le_bytes),
            wide([0xfe, 0xff], u16::to_be_bytes),
            text.replace('\n', "\r").into_bytes(),
            text.replace('\n', "\r\n").into_bytes(),
            format!("\n\r \t{text}\r\n\u{1a}").into_bytes(),
        ] {
            // What files of old end with is looked for in those that there were then.
            if bytes.ends_with(b"\x1a") && !matches!(kind, "fractint" | "csv") {
                continue;
            }
            assert_eq!(read(&bytes).as_ref(), Ok(&wanted), "{kind}: {bytes:?}");
        }
    }
}

#[test]
fn sixty_four_maps_are_read_and_no_more() {
    for (format, refused) in READ.into_iter().zip(["json-maps", "ifs-maps", "flame-maps", "table-maps"]) {
        let text = |count: usize| export(&system(count), format).unwrap();
        assert_eq!(read(text(64).as_bytes()).unwrap().systems[0].maps.len(), 64, "{format:?}");
        assert_eq!(code(&text(65)), refused);
    }
    assert_eq!(read(tile(64).as_bytes()).unwrap().systems[0].maps.len(), 64);
    assert_eq!(code(&tile(65)), "aifs-unread");
    // A million of them are too large, or are not all kept.
    let row = "1 2 3 4 5 6\n".repeat(1_000_000);
    assert_eq!(code(&row), "file-too-large");
    assert_eq!(code(&format!("a {{\n{row}}}")), "file-too-large");
    assert_eq!(code(&format!("[{}[1,2,3,4,5,6]]", "[1,2,3,4,5,6],".repeat(1_000_000))), "file-too-large");
    let few = "[0,0,0,0,0,0],".repeat(70_000);
    assert_eq!(code(&format!("[{few}[1,2,3,4,5,6]]")), "json-maps");
    let transforms = "<xform/>".repeat(1_000_000);
    assert_eq!(code(&format!("<flame>{transforms}</flame>")), "flame-maps");
}

#[test]
fn numbers_without_end_are_told() {
    for number in ["NaN", "nan", "1e999", "-1e999", "inf", "-Infinity", "0x1p3", "1e", "1.2.3"] {
        for (text, wanted) in [
            (format!("{{\"maps\": [\n[{number},0,0,0,0,0]]}}"), "json-broken"),
            (format!("a {{\n {number} 0 0 .5 0 0 1\n}}"), "ifs-number"),
            (format!("<flame>\n<xform coefs='{number} 0 0 .5 0 0'/></flame>"), "flame-number"),
            (format!("<flame>\n<xform weight='{number}' coefs='.5 0 0 .5 0 0'/></flame>"), "flame-number"),
            (format!(".5 0 0 .5 0 0\n{number} 0 0 .5 0 0\n"), "table-number"),
            (format!("@\nA=[{number},0,0,.5]*A\n"), "aifs-unread"),
        ] {
            let error = read(text.as_bytes()).unwrap_err();
            assert_eq!(error.code(), wanted, "{text}");
            assert!(error.to_string().contains("Line 2"), "{error}");
        }
    }
}

#[test]
fn what_is_nested_without_end_is_refused() {
    let deep = |open: &str, close: &str| format!("{}{}", open.repeat(100_000), close.repeat(100_000));
    assert_eq!(code(&deep("[", "]")), "json-broken");
    assert_eq!(code(&format!("{{\"maps\":{}", "{\"a\":".repeat(100_000))), "json-broken");
    assert_eq!(code(&format!("<flame>{}</flame>", deep("<a>", "</a>"))), "flame-not-affine");
    assert_eq!(code(&deep("<flame>", "</flame>")), "flame-not-affine");
    assert_eq!(code(&format!("@\nA={}*A\n", deep("(", ")"))), "aifs-unread");
    assert_eq!(code(&deep("a {", "}")), "ifs-brace");
}
