//! Files with maps, each language by itself: which it is is told from the file, as always.

use frond_exchange::{ExportFormat, Maps, System, export, import};

use crate::reader::Reader;

/// Fractint's `.ifs` files.
pub const FRACTINT: Reader = Reader {
    name: "fractint",
    read,
    words: &[
        "{",
        "}",
        ";",
        "(3D)",
        "(3d)",
        "comment {",
        "\n",
        ",",
        ".5 0 0 .5 0 0 1",
        "name",
        "\u{1a}",
        "\t",
    ],
};

/// Flames.
pub const FLAME: Reader = Reader {
    name: "flame",
    read,
    words: &[
        "<flame name='a'>",
        "</flame>",
        "<xform weight='1' coefs='.5 0 0 .5 0 0' linear='1'/>",
        "<finalxform coefs='1 0 0 1 0 0' linear='1'/>",
        "<layer>",
        "<jwf-flame>",
        "post='1 0 0 1 1 1'",
        "linear3D='1'",
        "affine3D='1 0 0 0 1 0 0 0 1 0 0 0'",
        "yzCoefs='1 0 0 1 0 0'",
        "zxPost='0 1 1 0 0 0'",
        "preserve_z='1'",
        "color='0.5'",
        "symmetry='-2'",
        "<symmetry kind='-3'/>",
        "opacity='0'",
        "chaos='1 0 2'",
        "xaos='1 0'",
        "plotmode='off'",
        "enabled='0'",
        "soloxform='1'",
        "<palette count='256' format='RGB'>",
        "<color index='3' rgb='1 2 3'/>",
        "<colors count='2' data='00ff8800112233'/>",
        "scale='100' center='0 0' size='640 480' zoom='1'",
        "&amp;",
        "&#x10FFFF;",
        "&#0;",
        "<!DOCTYPE a [<!ENTITY b 'c'>]>&b;",
        "julia='1'",
        "coefs=''",
    ],
};

/// Programs of IFStile.
pub const AIFS: Reader = Reader {
    name: "aifs",
    read,
    words: &[
        "@",
        "@a:b",
        "$dim=2",
        "$dim=3",
        "$n=\"a\"",
        "$subspace=[s,0]",
        "$root=A",
        "$camera=[0,0,1]",
        "$exchange()",
        "$companion([1,-1])",
        "$charpoly(A)",
        "$e(0)",
        "$number",
        "$vector([1,2])",
        "$diagonal([1,2])",
        "$integer()",
        "sin(",
        "cos(",
        "sqrt(",
        "|",
        "*",
        "^-1",
        "^100000",
        "^(1/2)",
        "?",
        ":",
        "[",
        "]",
        "(",
        ")",
        "-",
        "/0",
        "%",
        "=",
        "S=(f|g)*S",
        "f=[1,0]*2^-1",
        "pi",
        "\\",
        "\n",
        "@@",
        "<",
        ">=",
        "&",
        "&&",
        "||",
        "!",
        ";",
        "//",
        "/*",
        "*/",
        "()",
        "[0]",
        "[-1]",
        "$1",
        "$$",
        "99999999999999999999",
        "1/3",
        "2^0.5",
    ],
};

/// Maps as JSON, and documents.
pub const JSON: Reader = Reader {
    name: "json",
    read,
    words: &[
        "{\"maps\":[[0.5,0,0,0.5,0,0]]}",
        "\"maps\":",
        "\"a\":",
        "\"probabilities\":[1,2]",
        "\"name\":\"\"",
        "\"link\":\"v=1&a=fern\"",
        "\"colours\":[\"#ff0000\"]",
        "\"p\":0.5",
        "\"sqrt(2)/2\"",
        "\"1/3\"",
        "[",
        "]",
        "{",
        "}",
        ",",
        "null",
        "true",
        "\"",
        "\\u0000",
        "\\ud800",
        "1e999",
        "-0",
        "\u{feff}",
    ],
};

/// Tables of maps.
pub const TABLE: Reader = Reader {
    name: "table",
    read,
    words: &[
        "a,b,c,d,e,f,p",
        "f1",
        ";",
        ",",
        "\t",
        "|",
        "&",
        "\\\\",
        "\\hline",
        "\\begin{tabular}{cccccc}",
        "\\end{tabular}",
        "\\frac{1}{2}",
        "\\sqrt{3}",
        "{{",
        "}}",
        "[",
        "]",
        "f(x, y) = ",
        "x' = 0.5 x + 0.1 y + 1",
        "y' = ",
        "%",
        "#",
        "//",
        "−",
        "½",
        "cos(",
        "pi",
        "1/3",
        "0,5",
        "w",
        "$",
        "1^",
    ],
};

/// Formats that hold the text of doubles.
const EXACT: [ExportFormat; 4] =
    [ExportFormat::Json, ExportFormat::Fractint, ExportFormat::Flame, ExportFormat::Csv];

fn read(bytes: &[u8]) {
    match import(bytes) {
        Ok(found) => {
            assert!(found.systems.len() <= 1000);
            assert!(found.link.is_some() || !found.systems.is_empty(), "nothing was read");
            found.systems.iter().take(20).for_each(sound);
        }
        Err(error) => assert!(error.to_string().len() < 700, "{error}"),
    }
}

fn bits(maps: &Maps) -> Vec<u64> {
    maps.rows().into_iter().flatten().map(|x| x.to_bits()).collect()
}

/// It is one that can be shown and written, and what is written of it comes back.
fn sound(system: &System) {
    assert!((1..=64).contains(&system.maps.len()), "{} maps", system.maps.len());
    assert!(system.name.chars().count() <= 60, "{}", system.name);
    assert!(system.maps.rows().into_iter().flatten().all(|x| x.is_finite()), "{system:?}");
    let _ = system.check();
    for format in ExportFormat::ALL {
        let Ok(text) = export(system, format) else { continue };
        if !EXACT.contains(&format) {
            continue;
        }
        let again = import(text.as_bytes()).unwrap_or_else(|error| panic!("{format:?}: {error}\n{text}"));
        assert_eq!(again.systems.len(), 1, "{format:?}\n{text}");
        assert_eq!(bits(&again.systems[0].maps), bits(&system.maps), "{format:?}\n{text}");
        if !system.probabilities.is_empty() {
            assert_eq!(again.systems[0].probabilities, system.probabilities, "{format:?}\n{text}");
        }
    }
}
