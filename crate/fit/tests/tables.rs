//! Tables as other programs write them: with headings, columns that count rows, and several outlines.

use frond_fit::{FileContent, ReadAs, read_file};
use glam::DVec2;

/// A shape that is not as high as it is wide, and has another one on its side.
const POINTS: [[f64; 2]; 5] = [[0.0, 0.0], [6.0, 0.5], [6.5, 3.0], [2.0, 4.0], [-1.0, 2.0]];

/// Names and points of outlines, and what is said.
fn read(bytes: &[u8]) -> (Vec<(String, Vec<DVec2>)>, Vec<String>) {
    match read_file(bytes, ReadAs::Guess) {
        Ok(FileContent::Outlines { outlines, remarks, .. }) => (
            outlines.iter().map(|one| (one.name.clone(), one.outline.points().to_vec())).collect(),
            remarks.into_iter().map(|remark| remark.message).collect(),
        ),
        other => panic!("no outlines: {other:?} of {}", String::from_utf8_lossy(bytes)),
    }
}

/// The rows of a table, each made of its number and a point.
fn rows(row: impl Fn(usize, f64, f64) -> String) -> String {
    POINTS.iter().enumerate().map(|(k, [x, y])| row(k, *x, *y) + "\n").collect()
}

fn points() -> Vec<DVec2> {
    POINTS.map(DVec2::from).to_vec()
}

#[track_caller]
fn is_the_shape(text: &str) -> Vec<String> {
    let (found, remarks) = read(text.as_bytes());
    assert_eq!(found.len(), 1, "{text}");
    assert_eq!(found[0].1, points(), "{text}");
    remarks
}

#[test]
fn headings_say_which_columns_are_x_and_y() {
    let third = |k: usize| (7 * k * k) % 5;
    for (heading, columns) in [
        ("leaf,area,x,y", "7,123.5,X,Y"),
        ("y,x", "Y,X"),
        ("Y (px);X (px)", "Y;X"),
        ("width,y_mm,x_mm", "K,Y,X"),
        ("lat,lon", "Y,X"),
        ("BX,BY,x,y", "9,K,X,Y"),
        ("BX,BY,height", "X,Y,K"),
        ("\"y\",\"x\"", "Y,X"),
        ("y x", "Y X"),
        ("# y x", "Y X"),
        ("t\tx\ty", "K\tX\tY"),
        ("measured on Monday\nheight,y,x\nmm,mm,mm", "K,Y,X"),
    ] {
        let body = rows(|k, x, y| {
            columns
                .replace('X', &x.to_string())
                .replace('Y', &y.to_string())
                .replace('K', &third(k).to_string())
        });
        let remarks = is_the_shape(&format!("{heading}\n{body}"));
        let usual = ["leaf", "BX,BY,x", "BX,BY,h", "t\tx"].iter().any(|start| heading.starts_with(start));
        let said = if usual { "Only columns" } else { "the heading says" };
        assert!(remarks.iter().any(|remark| remark.contains(said) || remark.contains("Only")), "{remarks:?}");
    }
    let (_, remarks) =
        read(format!("leaf,area,x,y\n{}", rows(|_, x, y| format!("7,1.5,{x},{y}"))).as_bytes());
    assert_eq!(remarks, ["Only columns 3 (“x”) and 4 (“y”) of the table were read."]);
    let (_, remarks) = read(format!("y,x\n{}", rows(|_, x, y| format!("{y},{x}"))).as_bytes());
    assert_eq!(remarks, ["As the heading says, column 2 (“x”) is read as x and column 1 (“y”) as y."]);
}

#[test]
fn what_counts_rows_is_no_coordinate() {
    for (text, said) in [
        (format!("\"\",\"x\",\"y\"\r\n{}", rows(|k, x, y| format!("\"{}\",{x},{y}\r", k + 1))), "Only"),
        (format!("x y\n{}", rows(|k, x, y| format!("{} {x} {y}", k + 1))), "Only"),
        (format!("\"x\" \"y\"\n{}", rows(|k, x, y| format!("\"p{k}\" {x} {y}"))), "Only"),
        (format!(",x,y\n{}", rows(|k, x, y| format!("{k},{x},{y}"))), "Only"),
        (format!("\tx\ty\n{}", rows(|k, x, y| format!("{k}\t{x}\t{y}"))), "Only"),
        (format!("Unnamed: 0,a,b\n{}", rows(|k, x, y| format!("{k},{x},{y}"))), "Only"),
        (format!("point;x;y\n{}", rows(|k, x, y| format!("{k};{x};{y}"))), "Only"),
        (rows(|k, x, y| format!("{k},{x},{y}")), "Column 1 is taken to count rows"),
        (rows(|k, x, y| format!("{}\t{x}\t{y}", k + 1)), "Column 1 is taken to count rows"),
        (rows(|_, x, y| format!("7 {x} {y}")), "Column 1 is taken to count rows"),
    ] {
        let remarks = is_the_shape(&text);
        assert!(remarks.iter().any(|remark| remark.starts_with(said)), "{text}: {remarks:?}");
    }
    // Days and two values are a series, and so is one value with its row.
    for text in ["day,a,b\n1,5,2\n2,7,3\n3,6,9\n", "day,a\n1,5\n2,7\n3,6\n", ",a\n0,5\n1,7\n2,6\n"] {
        let Ok(FileContent::Series { points, .. }) = read_file(text.as_bytes(), ReadAs::Guess) else {
            panic!("{text}")
        };
        assert_eq!(points[1].y, 7.0, "{text}");
    }
}

#[test]
fn rows_that_may_be_maps_are_named() {
    let text = "1 0 0 0 .16 0 0 .01\n2 .85 .04 -.04 .85 0 1.6 .85\n3 .2 -.26 .23 .22 0 1.6 .07\n4 -.15 .28 .26 .24 0 .44 .07\n";
    let (_, remarks) = read(text.as_bytes());
    assert!(remarks.iter().any(|remark| remark.contains("open it in Morph")), "{remarks:?}");
}

#[test]
fn imagej_counts_y_from_the_top() {
    for parted in [",", "\t"] {
        let text =
            format!(" {parted}X{parted}Y\n{}", rows(|k, x, y| format!("{}{parted}{x}{parted}{y}", k + 1)));
        let (found, remarks) = read(text.as_bytes());
        let mut points = found[0].1.clone();
        points.sort_by(|a, b| a.x.total_cmp(&b.x));
        assert_eq!(points[0], DVec2::new(-1.0, -2.0));
        assert!(remarks.iter().any(|remark| remark.contains("turned upright")), "{remarks:?}");
    }
}

#[test]
fn signs_of_typesetters_are_read() {
    for text in [
        rows(|_, x, y| format!("{x},{y}").replace('-', "\u{2212}")),
        rows(|_, x, y| format!("{x}\u{a0}\u{2009}{y}").replace('-', "–")),
        rows(|_, x, y| format!("{x};{y}").replace('.', ",").replace('-', "\u{2212}")),
        rows(|_, x, y| format!("({x}, {y}),")),
        rows(|_, x, y| format!("[{x}, {y}],")),
        format!("outline = [\n{}]\n", rows(|_, x, y| format!("    ({x}, {y}),"))),
        format!("x|y\n{}", rows(|_, x, y| format!("{x}|{y}"))),
        format!("| x | y |\n|---|---|\n{}", rows(|_, x, y| format!("| {x} | {y} |"))),
        rows(|_, x, y| format!("{x},{y}\r")) + "\x1a",
    ] {
        let remarks = is_the_shape(&text);
        assert!(remarks.iter().all(|remark| remark.contains("decimal sign")), "{text}: {remarks:?}");
    }
    let printed =
        "        [,1]   [,2]\n".to_string() + &rows(|k, x, y| format!(" [{},] {x:.3} {y:.3}", k + 1));
    is_the_shape(&printed);
    let text = rows(|_, x, y| format!("{x},{y}"));
    for bytes in [
        text.encode_utf16().flat_map(u16::to_le_bytes).collect::<Vec<u8>>(),
        text.encode_utf16().flat_map(u16::to_be_bytes).collect(),
        text.replace('-', "\u{96}").chars().map(|c| c as u8).collect(),
    ] {
        assert_eq!(read(&bytes).0[0].1, points());
    }
}

/// Two shapes, the second twice as large.
fn pair(row: impl Fn(usize, usize, f64, f64) -> String, between: &str) -> String {
    let of = |k: usize| {
        let scale = (k + 1) as f64;
        rows(|j, x, y| row(k, j, 20.0 * k as f64 + scale * x, scale * y))
    };
    format!("{}{between}{}", of(0), of(1))
}

#[test]
fn a_table_has_several_outlines() {
    let plain = |_, _, x, y| format!("{x},{y}");
    let closed = |between: &str| {
        let ring = |scale: f64| {
            let row = |[x, y]: [f64; 2]| format!("{},{}\n", scale * x, scale * y);
            POINTS.into_iter().chain([POINTS[0]]).map(row).collect::<String>()
        };
        format!("{}{between}{}", ring(1.0), ring(2.0))
    };
    for (text, names) in [
        (format!("leaf,x,y\n{}", pair(|k, _, x, y| format!("{},{x},{y}", k + 3), "")), ["leaf 4", "leaf 3"]),
        (
            format!("x,y,specimen\n{}", pair(|k, _, x, y| format!("{x},{y},{}", ["oak", "elm"][k]), "")),
            ["elm", "oak"],
        ),
        (pair(|k, _, x, y| format!("{} {x} {y}", ["oak", "elm"][k]), ""), ["elm", "oak"]),
        (pair(|k, _, x, y| format!("{}\t{x}\t{y}", k + 1), ""), ["outline 2", "outline 1"]),
        (
            format!("plant,leaf,x,y\n{}", pair(|k, _, x, y| format!("A,{k},{x},{y}"), "")),
            ["leaf 1", "leaf 0"],
        ),
        (pair(plain, "\n\n"), ["outline 2", "outline 1"]),
        (format!("oak\nx,y\n{}", pair(plain, "elm\nx,y\n")), ["elm", "oak"]),
        (format!("# oak\n{}", pair(plain, "\n# elm\n")), ["elm", "oak"]),
        (closed("NaN,NaN\n"), ["outline 2", "outline 1"]),
        (closed(",\n"), ["outline 2", "outline 1"]),
    ] {
        let (found, remarks) = read(text.as_bytes());
        let told: Vec<&str> = found.iter().map(|(name, _)| name.as_str()).collect();
        assert_eq!(told, names, "{text}");
        assert_eq!(found[1].1, points(), "{text}");
        assert!(remarks.iter().any(|remark| remark.contains("2 outlines")), "{text}: {remarks:?}");
        assert!(!remarks.iter().any(|remark| remark.contains("no finite")), "{text}: {remarks:?}");
    }
    // Rows of one outline need not follow each other.
    let mixed: String = (0..5)
        .flat_map(|j| (0..2).map(move |k| (j, k)))
        .map(|(j, k)| {
            let [x, y] = POINTS[j].map(|value| value * (k + 1) as f64);
            format!("{},{x},{y}\n", ["oak", "elm"][k])
        })
        .collect();
    let (found, _) = read(format!("leaf,x,y\n{mixed}").as_bytes());
    assert_eq!((found[0].0.as_str(), &found[1].1), ("elm", &points()));
}

#[test]
fn one_outline_stays_one() {
    let half = rows(|_, x, y| format!("{x},{y}"));
    let dense: String = (0..40)
        .map(|k| {
            let p = DVec2::from_angle(f64::from(k) * std::f64::consts::TAU / 40.0);
            format!("{},{}\n{}", p.x, p.y, if k == 20 { "\n" } else { "" })
        })
        .collect();
    for text in [
        half.replace('\n', "\n\n"),
        dense.clone(),
        dense.replace("\n\n", "\nNA,NA\n"),
        format!("id,x,y\n{}", rows(|k, x, y| format!("{k},{x},{y}"))),
        format!("name,x,y\n{}", rows(|k, x, y| format!("p{k},{x},{y}"))),
        format!("leaf,x,y\n{}", rows(|_, x, y| format!("7,{x},{y}"))),
    ] {
        assert_eq!(read(text.as_bytes()).0.len(), 1, "{text}");
    }
}

#[test]
fn specimens_of_tps_are_outlines() {
    let ring = rows(|_, x, y| format!("{x:.5} {y:.5}\r"));
    let one = |k: usize| {
        format!("LM=0\r\nCURVES=1\r\nPOINTS=5\r\n{ring}IMAGE=leaf_{k}.jpg\r\nID={k}\r\nSCALE=0.0123\r\n")
    };
    let (found, remarks) = read(one(1).as_bytes());
    assert_eq!(found, [("leaf_1.jpg".to_string(), points())]);
    assert_eq!(remarks.len(), 1, "{remarks:?}");
    let (found, _) = read(format!("{}{}", one(1), one(2)).as_bytes());
    let names: Vec<&str> = found.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(names, ["leaf_1.jpg", "leaf_2.jpg"]);
    assert!(found.iter().all(|(_, found)| *found == points()));
}
