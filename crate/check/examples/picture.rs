//! The picture of the documentation, what a certificate says: `cargo run --release -p frond-check --example picture >
//! crate/check/picture.svg`.

use frond_check::{Certificate, Pair, check};

/// Corners of the polygon; how much each map scales, and turns.
const CORNERS: usize = 12;
const SCALE: f64 = 0.42;
const TURN: f64 = 0.55;

type Polygon = Vec<[f64; 2]>;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // Three similar pieces around the origin, all turned.
    let (s, c) = TURN.sin_cos();
    let map = |k: u8| {
        let (y, x) = (std::f64::consts::TAU * (0.25 + f64::from(k) / 3.0)).sin_cos();
        [SCALE * c, -SCALE * s, SCALE * s, SCALE * c, x, y]
    };
    let corner = |k: usize| {
        let (y, x) = (std::f64::consts::TAU * k as f64 / CORNERS as f64).sin_cos();
        [1.9 * x, 1.9 * y]
    };
    let mut certificate = Certificate {
        maps: (0..3).map(map).collect(),
        polygon: (0..CORNERS).map(corner).collect(),
        letters: 1,
        side: vec![0, 1, 1],
        pairs: Vec::new(),
        exact: None,
    };
    descend(&mut certificate, &[0], &[1])?;
    descend(&mut certificate, &[0], &[2])?;
    let checked = check(&certificate)?;
    eprintln!("{checked:?}");

    println!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"60%\" viewBox=\"-200 -200 400 400\" role=\"img\">"
    );
    println!(
        "<title>A polygon around a shape, and pieces on two sides of a cut that a certificate shows apart</title>"
    );
    let draw = |polygon: &Polygon| {
        let corners: Vec<String> =
            polygon.iter().map(|[x, y]| format!("{:.1} {:.1}", 100.0 * x, -100.0 * y)).collect();
        format!("M{}z", corners.join("L"))
    };
    println!(
        "<path fill=\"none\" stroke=\"#808080\" stroke-width=\"2\" d=\"{}\"/>",
        draw(&certificate.polygon)
    );
    for (colour, side) in [("#2b7fb8", 0), ("#c47800", 1)] {
        // The pieces that the certificate names, and smaller ones: the shape is in all of them.
        let mut words: Vec<Vec<u8>> =
            certificate.pairs.iter().map(|pair| if side == 0 { &pair.u } else { &pair.v }).cloned().collect();
        words.sort_unstable();
        words.dedup();
        let outer: String = words.iter().map(|word| draw(&piece(&certificate, word))).collect();
        for _ in 0..4 {
            words =
                words.iter().flat_map(|word| (0..3).map(|letter| [word, &[letter][..]].concat())).collect();
        }
        let inner: String = words.iter().map(|word| draw(&piece(&certificate, word))).collect();
        println!("<path fill=\"none\" stroke=\"{colour}\" stroke-width=\"1.5\" d=\"{outer}\"/>");
        println!("<path fill=\"{colour}\" d=\"{inner}\"/>");
    }
    println!("</svg>");
    Ok(())
}

/// Where a word takes the polygon.
fn piece(certificate: &Certificate, word: &[u8]) -> Polygon {
    word.iter().rev().fold(certificate.polygon.clone(), |polygon, &letter| {
        let [a, b, c, d, e, f] = certificate.maps[usize::from(letter)];
        polygon.iter().map(|[x, y]| [a * x + b * y + e, c * x + d * y + f]).collect()
    })
}

/// Splits the longer word, until a line parts the pieces.
fn descend(certificate: &mut Certificate, u: &[u8], v: &[u8]) -> Result<(), &'static str> {
    let (one, other) = (piece(certificate, u), piece(certificate, v));
    for k in 0..24 {
        let (y, x) = (std::f64::consts::TAU * f64::from(k) / 24.0).sin_cos();
        let along = |point: &[f64; 2]| point[0] * x + point[1] * y;
        let (far, near) = (one.iter().map(along), other.iter().map(along));
        if far.fold(f64::MIN, f64::max) < near.fold(f64::MAX, f64::min) - 1e-9 {
            certificate.pairs.push(Pair { u: u.to_vec(), v: v.to_vec(), normal: [x, y] });
            return Ok(());
        }
    }
    if u.len() > 9 {
        return Err("these are not apart");
    }
    for letter in 0..3 {
        if u.len() <= v.len() {
            descend(certificate, &[u, &[letter]].concat(), v)?;
        } else {
            descend(certificate, u, &[v, &[letter]].concat())?;
        }
    }
    Ok(())
}
