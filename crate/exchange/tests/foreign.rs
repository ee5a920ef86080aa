//! Maps as books, encyclopedias and other programs write them, as files of any kind.

use frond_exchange::{Imported, Maps, import};

const FERN: [[f64; 6]; 2] = [[0.0, 0.0, 0.0, 0.16, 0.0, 0.0], [0.85, 0.04, -0.04, 0.85, 0.0, 1.6]];

#[track_caller]
fn read(bytes: &[u8]) -> Imported {
    import(bytes).unwrap_or_else(|error| panic!("{error}: {}", String::from_utf8_lossy(bytes)))
}

#[test]
fn maps_are_read_whatever_wrote_them() {
    for (text, format) in [
        (
            "w\ta\tb\tc\td\te\tf\tp\nƒ1\t0\t0\t0\t0.16\t0\t0\t0.01\nƒ2\t0.85\t0.04\t−0.04\t0.85\t0\t1.6\t0.85\n",
            "table",
        ),
        ("T1 0 0 0 0.16 0 0 0.01\nT2 0.85 0.04 -0.04 0.85 0 1.6 0.85\n\x1a", "table"),
        ("1 0 0 0 0.16 0 0 0.01\n2 0.85 0.04 -0.04 0.85 0 1.6 0.85\n", "table"),
        (
            "0\u{a0}0\u{a0}0\u{a0}0,16\u{a0}0\u{a0}0\u{a0}0,01\n0,85\u{a0}0,04\u{a0}−0,04\u{a0}0,85\u{a0}0\u{a0}1,6\u{a0}0,85\n",
            "table",
        ),
        (
            "\\begin{tabular}{c}\na & b & c & d & e & f & p\\\\\n0 & 0 & 0 & 4/25 & 0 & 0 & 0.01\\\\\n0.85 & 0.04 & $-\\frac{1}{25}$ & 0.85 & 0 & 1.6 & 0.85\\\\\n\\end{tabular}\n",
            "table",
        ),
        ("[0, 0, 0, 0.16, 0, 0, 0.01],\n[0.85, 0.04, -0.04, 0.85, 0, 1.6, 0.85]\n", "table"),
        ("{{0, 0, 0, 0.16, 0, 0, 0.01}, {0.85, 0.04, -0.04, 0.85, 0, 1.6, 0.85}}", "table"),
        ("[[0, 0, 0, 0.16, 0, 0, 0.01], [0.85, 0.04, -0.04, 0.85, 0, 1.6, 0.85]]", "json"),
        (
            "{\"transforms\": [{\"a\": 0, \"b\": 0, \"c\": 0, \"d\": 0.16, \"e\": 0, \"f\": 0, \"p\": 0.01}, {\"a\": 0.85, \"b\": 0.04, \"c\": -0.04, \"d\": 0.85, \"e\": 0, \"f\": 1.6, \"p\": 0.85}]}",
            "json",
        ),
        (
            "{\"transformations\": [[\"0.01\", \"0, .16*y\"], [\"0.85\", \".85*x + .04*y, -.04*x + .85*y + 1.6\"]]}",
            "json",
        ),
        ("fern {\n 0 0 0 0,16 0 0 0,01\n 0,85 0,04 -0,04 0,85 0 1,6 0,85\n}\n", "fractint"),
        ("fern {\n 0 0 0 .16 0 0 .01\n .85 .04 \u{2212}.04 .85 0 1.6 .85\n}\n\x1a", "fractint"),
    ] {
        for bytes in [text.as_bytes().to_vec(), text.encode_utf16().flat_map(u16::to_le_bytes).collect()] {
            let found = read(&bytes);
            assert_eq!(found.format.id(), format, "{text}");
            assert_eq!(found.systems.len(), 1, "{text}");
            assert_eq!(found.systems[0].maps, Maps::Plane(FERN.to_vec()), "{text}");
            assert_eq!(found.systems[0].probabilities, [0.01, 0.85], "{text}");
        }
    }
}

#[test]
fn what_was_assumed_is_said() {
    for (text, said) in [
        ("1 0 0 0 0.16 0 0 0.01\n2 0.85 0.04 -0.04 0.85 0 1.6 0.85\n", "counts the maps"),
        (
            "p a b c d e f\n0.01 0 0 0 0.16 0 0\n0.85 0.85 0.04 -0.04 0.85 0 1.6\n",
            "the columns are p a b c d e f",
        ),
        ("0 0 0 0,16 0 0 0,01\n0,85 0,04 -0,04 0,85 0 1,6 0,85\n", "taken for decimal points"),
    ] {
        let found = read(text.as_bytes());
        assert!(found.remarks.iter().any(|remark| remark.contains(said)), "{:?}", found.remarks);
    }
    let angles = import(b"r s theta phi e f p\n0 .16 0 0 0 0 .01\n").unwrap_err();
    assert_eq!(angles.code(), "table-angles");
}
