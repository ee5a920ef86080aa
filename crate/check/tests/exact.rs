//! Certificates about exact numbers: what is true of these is accepted, and nothing that is not.

use frond_check::{
    Address, Certificate, ConnectedCertificate, Exact, ExactEntry, Link, Pair, check, check_connected,
};

/// The double of some powers of a root.
fn double(root: f64, value: &[&str]) -> f64 {
    let fraction = |text: &str| {
        let (over, under) = text.split_once('/').unwrap_or((text, "1"));
        over.parse::<f64>().unwrap() / under.parse::<f64>().unwrap()
    };
    value.iter().rev().fold(0.0, |sum, text| sum * root + fraction(text))
}

/// Maps, and which of their entries are exact: `root` is the double of the root.
struct Field<'a> {
    polynomial: &'a [&'a str],
    ends: [&'a str; 2],
    root: f64,
}

const FRACTIONS: Field = Field { polynomial: &["0", "1"], ends: ["-1", "1"], root: 0.0 };
const ROOT_3: Field =
    Field { polynomial: &["-3", "0", "1"], ends: ["17/10", "9/5"], root: 1.732_050_807_568_877_2 };

impl Field<'_> {
    fn maps(&self, rows: &[[&[&str]; 6]]) -> (Vec<[f64; 6]>, Option<Exact>) {
        let mut entries = Vec::new();
        for (map, row) in rows.iter().enumerate() {
            for (entry, value) in row.iter().enumerate().filter(|(_, value)| !value.is_empty()) {
                let value = value.iter().map(|&text| text.to_owned()).collect();
                entries.push(ExactEntry { map: map as u8, entry: entry as u8, value });
            }
        }
        let maps = rows.iter().map(|row| row.map(|value| double(self.root, value))).collect();
        let polynomial = self.polynomial.iter().map(|&text| text.to_owned()).collect();
        (maps, Some(Exact { polynomial, root: self.ends.map(str::to_owned), entries }))
    }
}

fn square(x: f64, y: f64, half: f64) -> Vec<[f64; 2]> {
    [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(|[i, j]| [x + i * half, y + j * half]).to_vec()
}

/// One point, which is where a map takes the point that another fixes, in two ways.
fn link([i, k]: [u8; 2], [j, l]: [u8; 2]) -> Link {
    Link::Point {
        addresses: [[i, k], [j, l]].map(|[head, repeat]| Address { head: vec![head], repeat: vec![repeat] }),
    }
}

fn connected(
    (maps, exact): (Vec<[f64; 6]>, Option<Exact>),
    polygon: Vec<[f64; 2]>,
    links: Vec<Link>,
) -> ConnectedCertificate {
    ConnectedCertificate { maps, polygon, gap: 1.0, near: Vec::new(), links, squares: None, exact }
}

/// Four pieces from 0 to 1, a third as long, each beginning where the one before it ends.
fn koch() -> ConnectedCertificate {
    let (third, sixth): (&[&str], &[&str]) = (&["1/3"], &["1/6"]);
    let (up, down): (&[&str], &[&str]) = (&["0", "1/6"], &["0", "-1/6"]);
    let rows = [
        [third, &[], &[], third, &[], &[]],
        [sixth, down, up, sixth, third, &[]],
        [sixth, up, down, sixth, &["1/2"], up],
        [third, &[], &[], third, &["2/3"], &[]],
    ];
    let links = (0..3).map(|k| link([k, 3], [k + 1, 0])).collect();
    connected(ROOT_3.maps(&rows), square(0.5, 0.0, 2.0), links)
}

fn segment() -> ConnectedCertificate {
    let third: &[&str] = &["1/3"];
    let row = |e| [third, &[], &[], third, e, &[]];
    let links = (0..2).map(|k| link([k, 2], [k + 1, 0])).collect();
    connected(FRACTIONS.maps(&[row(&[]), row(third), row(&["2/3"])]), square(0.5, 0.0, 1.0), links)
}

fn gasket() -> ConnectedCertificate {
    let half: &[&str] = &["1/2"];
    let row = |e, f| [half, &[], &[], half, e, f];
    let rows = [row(&[], &[]), row(half, &[]), row(&["1/4"], &["0", "1/4"])];
    let links = [[0, 1], [1, 2]].map(|[i, j]| link([i, j], [j, i])).to_vec();
    connected(ROOT_3.maps(&rows), square(0.5, 0.5, 1.0), links)
}

/// Five pieces toward the corners of a regular pentagon, of the ratio at which neighbours share one point. With s = 2
/// sin 72°, s^4 - 5 s^2 + 5 = 0, the ratio is 4 - s^2, and the corners are (1, 0), (s^2 - 3, s) / 2 and so on.
fn pentagon() -> ConnectedCertificate {
    let field = Field {
        polynomial: &["5", "0", "-5", "0", "1"],
        ends: ["19/10", "20/10"],
        root: 1.902_113_032_590_307,
    };
    let ratio: &[&str] = &["4", "0", "-1"];
    let row = |e, f| [ratio, &[], &[], ratio, e, f];
    let rows = [
        row(&["-3", "0", "1"], &[]),
        row(&["2", "0", "-1/2"], &["0", "-3/2", "0", "1/2"]),
        row(&["-1/2"], &["0", "2", "0", "-1/2"]),
        row(&["-1/2"], &["0", "-2", "0", "1/2"]),
        row(&["2", "0", "-1/2"], &["0", "3/2", "0", "-1/2"]),
    ];
    let links = (0..4).map(|k| link([k, (k + 2) % 5], [k + 1, (k + 4) % 5])).collect();
    let (mut maps, exact) = field.maps(&rows);
    // Sums of powers are a few units off.
    let digits = [
        0.381_966_011_250_105_15,
        0.618_033_988_749_894_8,
        0.190_983_005_625_052_58,
        0.587_785_252_292_473_1,
        0.363_271_264_002_680_44,
    ];
    for x in maps.iter_mut().flatten() {
        if let Some(&exact) = digits.iter().find(|&exact| (exact - x.abs()).abs() < 1e-9) {
            *x = exact.copysign(*x);
        }
    }
    connected((maps, exact), square(0.0, 0.0, 1.5), links)
}

fn main_cases() -> [(&'static str, ConnectedCertificate); 4] {
    [("koch", koch()), ("segment", segment()), ("gasket", gasket()), ("pentagon", pentagon())]
}

#[test]
fn shared_points_of_exact_numbers_are_accepted() {
    for (name, certificate) in main_cases() {
        assert_eq!(
            check_connected(&certificate).map(|found| found.links),
            Ok(certificate.links.len()),
            "{name}"
        );
    }
}
