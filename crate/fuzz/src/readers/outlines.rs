//! Files with outlines and series.

use frond_fit::{FileContent, MAX_OUTLINE, ReadAs, ReadError, read_file, sniff};

use crate::reader::Reader;

/// Drawings.
pub const SVG: Reader = Reader {
    name: "svg",
    read: guessed,
    words: &[
        "<path d='M0 0h4v3z'/>",
        "<g transform='rotate(30 1 2)'>",
        "</g>",
        "<use href='#a' x='1'/>",
        "<use xlink:href='#a'/>",
        "<symbol id='a' viewBox='0 0 1 1'>",
        "<clipPath id='c'>",
        "<mask id='m'>",
        "<defs>",
        "<svg viewBox='0 0 9 9' width='50%'>",
        "</svg>",
        "<rect x='1' y='1' width='3' height='2' rx='.5'/>",
        "<circle r='2'/>",
        "<ellipse rx='2' ry='1'/>",
        "<polygon points='0,0 1,0 1,1'/>",
        "<polyline points='0 0 1 0 1 1'/>",
        "<line x1='0' y1='0' x2='3' y2='1'/>",
        "<image href='data:image/png;base64,iVBORw0KGgo='/>",
        "<text x='1'>a</text>",
        "<style>.a{fill:red;transform:scale(2)}</style>",
        "style='transform:translate(10%,2px) rotate(1rad)'",
        "class='a'",
        "id='a'",
        "clip-path='url(#c)'",
        "mask='url(#m)'",
        "transform='matrix(1 0 0 1 0 0)'",
        "transform='skewX(90)'",
        "preserveAspectRatio='xMaxYMin slice'",
        "stroke='red' stroke-width='3' fill='none' stroke-dasharray='1 2'",
        "fill-rule='evenodd'",
        "visibility='hidden'",
        "display='none'",
        "A1 2 30 011 1",
        "a5 5 0 10-1-1",
        "c1 2 3 4 5 6",
        "Q1,2,3,4",
        "t1 1",
        "M",
        "z",
        "<!DOCTYPE svg [<!ENTITY a 'M0 0h1v1z'>]>",
        "&a;",
        "&lt;",
        "&#65;",
        "<![CDATA[",
        "]]>",
        "<?xml version='1.0' encoding='utf-16'?>",
        "xmlns:xlink='http://www.w3.org/1999/xlink'",
        "<switch>",
        "<a>",
        "<linearGradient id='l'>",
        "<pattern id='p' width='1' height='1'>",
        "<filter id='f'>",
        "<marker id='k'>",
        "!important",
        "}",
        "{",
    ],
};

/// Tables of points.
pub const CSV: Reader = Reader {
    name: "csv",
    read: in_all_ways,
    words: &[
        ",",
        ";",
        "\t",
        " ",
        "|",
        "\"",
        "'",
        "#",
        "x,y",
        "x;y",
        "id,x,y",
        "Time",
        "longitude",
        "latitude",
        "\n",
        "\n\n",
        "\r",
        "NA",
        "nan",
        "-",
        "1,5;2,5",
        "1.000,5",
        "2021-03-04",
        "12:30:00",
        "%",
        "°",
        "0;0",
        "sep=;",
        "\"a \"\"b\"\"\"",
        "group",
        "POINTS=3",
        "LM=3",
        "[[1,2],[3,4]]",
        "(1, 2)",
        "\\N",
        "true",
    ],
};

/// Landmarks of the programs of tpsDig.
pub const TPS: Reader = Reader {
    name: "tps",
    read: guessed,
    words: &[
        "LM=4",
        "LM3=2",
        "CURVES=1",
        "POINTS=3",
        "SCALE=0.5",
        "IMAGE=a.jpg",
        "ID=1",
        "OUTLINES=1",
        "RADII=1",
        "COMMENT=",
        "VARIABLES=",
        "\n",
        "1 2\n",
        "LM=0",
        "lm = 2",
        "LM=99999999999",
        "POINTS=-1",
        "SCALE=0",
    ],
};

/// JSON of maps of the world, and of programs that label pictures.
pub const GEOJSON: Reader = Reader {
    name: "geojson",
    read: guessed,
    words: &[
        "\"type\":\"FeatureCollection\"",
        "\"type\":\"Feature\"",
        "\"type\":\"Polygon\"",
        "\"type\":\"MultiPolygon\"",
        "\"type\":\"GeometryCollection\"",
        "\"type\":\"LineString\"",
        "\"type\":\"Topology\"",
        "\"features\":[",
        "\"geometry\":{",
        "\"geometries\":[",
        "\"coordinates\":[[[0,0],[4,0],[4,3],[0,0]]]",
        "\"arcs\":[[0,-1]]",
        "\"arcs\":[[[0,0],[1,1]]]",
        "\"transform\":{\"scale\":[0.1,0.1],\"translate\":[1,2]}",
        "\"objects\":{",
        "\"properties\":{\"name\":\"a\"}",
        "\"crs\":{\"type\":\"name\",\"properties\":{\"name\":\"EPSG:3857\"}}",
        "\"shapes\":[{\"points\":[[1,2],[3,4],[5,1]],\"label\":\"leaf\"}]",
        "\"imageHeight\":100",
        "\"segmentation\":[[1,2,3,4,5,1]]",
        "\"segmentation\":{\"counts\":[3,4],\"size\":[9,9]}",
        "\"annotations\":[",
        "\"regions\":{\"0\":{\"shape_attributes\":{\"name\":\"polygon\",\"all_points_x\":[1,2],\"all_points_y\":[1,2]}}}",
        "\"bbox\":[0,0,1,1]",
        "null",
        "{",
        "}",
        "[",
        "]",
        ",",
        "[180,90]",
        "[-180,-90]",
        "\"\\ud83d\"",
        "1e400",
    ],
};

fn guessed(bytes: &[u8]) {
    let _ = sniff(bytes);
    hold(&read_file(bytes, ReadAs::Guess));
}

fn in_all_ways(bytes: &[u8]) {
    guessed(bytes);
    hold(&read_file(bytes, ReadAs::Outlines));
    hold(&read_file(bytes, ReadAs::Series));
}

fn hold(outcome: &Result<FileContent, ReadError>) {
    match outcome {
        Ok(FileContent::Outlines { outlines, .. }) => {
            assert!((1..=100).contains(&outlines.len()), "{} outlines", outlines.len());
            for one in outlines {
                let points = one.outline.points();
                assert!((3..=MAX_OUTLINE).contains(&points.len()), "{} points", points.len());
                assert!(points.iter().all(|point| point.is_finite()), "{one:?}");
                // None where it crosses itself, and one part takes away what the other adds.
                let area = one.outline.area();
                assert!(area >= 0.0 && area.is_finite(), "an area of {area}");
            }
        }
        Ok(FileContent::Series { points, .. }) => {
            assert!((3..=MAX_OUTLINE).contains(&points.len()), "{} points", points.len());
            assert!(points.iter().all(|point| point.is_finite()), "{points:?}");
            assert!(points.is_sorted_by(|one, next| one.x < next.x), "{points:?}");
        }
        Err(error) => assert!(error.to_string().len() < 700, "{error}"),
    }
}
