//! The check.

use std::fmt;

use num_bigint::BigInt;

use crate::certificate::{Certificate, Pair};
use crate::cover::check_cover;
use crate::polygon::Scene;
use crate::refused::Refused;
use crate::whole::Whole;

/// What was checked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Checked {
    /// How many pairs of pieces were shown to be apart.
    pub pairs: usize,
    /// Letters of the longest word.
    pub longest: usize,
}

impl fmt::Display for Checked {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match (self.pairs, self.longest) {
            (1, _) => {
                write!(f, "One pair of pieces, and with it all, is apart: checked in exact arithmetic.")
            }
            (pairs, longest) => write!(
                f,
                "All {pairs} pairs of pieces, of at most {longest} letters, are apart: checked in exact arithmetic."
            ),
        }
    }
}

/// Letters are bytes.
const MAPS: usize = 256;
const CORNERS: usize = 512;
/// Words that map the polygon into itself.
const BLOCKS: usize = 4096;
const PAIRS: usize = 1_000_000;
/// Letters of one word, and of all words together.
const LETTERS: usize = 1000;
const TEXT: usize = 10_000_000;
/// Multiplications of machine words, roughly: a minute or two.
const WORK: u64 = 50_000_000_000;

/// Checks a certificate in exact arithmetic. What it proves is said in the [crate](crate).
///
/// # Errors
/// [`Refused`] with the first thing that is wrong with it, or that it is too large to be checked: more than 256 maps,
/// 512 corners, a million pairs, ten million letters.
///
/// ```
/// # use frond_check::{Certificate, Refused, check};
/// let none = Certificate { maps: vec![], polygon: vec![], letters: 1, side: vec![], pairs: vec![] };
/// assert_eq!(check(&none).unwrap_err().code(), "form");
/// ```
pub fn check(certificate: &Certificate) -> Result<Checked, Refused> {
    let Certificate { maps, polygon, letters, side, pairs } = certificate;
    let longest = check_form(certificate)?;
    let scene = Scene {
        maps: Whole::of(maps).ok_or(Refused::NotFinite { place: "maps" })?,
        corners: Whole::of(polygon).ok_or(Refused::NotFinite { place: "corners" })?,
    };
    check_work(certificate, &scene)?;
    scene.check_convex()?;
    for word in words(maps.len(), *letters) {
        scene.check_inside(&word)?;
    }
    check_cut(side)?;
    for (k, Pair { u, v, .. }) in pairs.iter().enumerate() {
        let is_of = |word: &[u8], wanted: u8| {
            let known = word.iter().all(|i| usize::from(*i) < maps.len());
            known && word.first().is_some_and(|&i| side[usize::from(i)] == wanted)
        };
        if !is_of(u, 0) || !is_of(v, 1) {
            return Err(Refused::Stray { pair: k });
        }
    }
    check_cover(certificate)?;
    for (k, Pair { u, v, normal }) in pairs.iter().enumerate() {
        let whole = Whole::of(&[*normal]).ok_or(Refused::NotFinite { place: "directions" })?;
        let [n_x, n_y] = &whole.rows[0];
        // The least along `n` is less the greatest along `-n`.
        let most = scene.farthest(u, [n_x.clone(), n_y.clone()], whole.bits);
        let mut least = scene.farthest(v, [-n_x, -n_y], whole.bits);
        least.far = -least.far;
        if !most.is_below(&least) {
            return Err(Refused::NotApart { pair: k, u: u.clone(), v: v.clone() });
        }
    }
    Ok(Checked { pairs: pairs.len(), longest })
}

/// Sizes and forms; the letters of the longest word.
fn check_form(certificate: &Certificate) -> Result<usize, Refused> {
    let Certificate { maps, polygon, letters, side, pairs } = certificate;
    let at_most = |count: usize, most: usize, what: &'static str| {
        if count > most { Err(Refused::TooLarge { what, most: most as u64 }) } else { Ok(()) }
    };
    at_most(maps.len(), MAPS, "maps")?;
    at_most(polygon.len(), CORNERS, "corners")?;
    at_most(pairs.len(), PAIRS, "pairs")?;
    if maps.is_empty() {
        return Err(Refused::Form { why: "it has no maps" });
    }
    if polygon.len() < 3 {
        return Err(Refused::Form { why: "its polygon has fewer than three corners" });
    }
    if *letters == 0 {
        return Err(Refused::Form { why: "it says nothing of words of no letters" });
    }
    let power = u32::try_from(*letters).ok().and_then(|power| maps.len().checked_pow(power));
    at_most(power.unwrap_or(usize::MAX), BLOCKS, "words that map the polygon")?;
    at_most(*letters, LETTERS, "letters in a word")?;
    if side.len() != maps.len() {
        return Err(Refused::Form { why: "its cut does not say for each map where it belongs" });
    }
    if pairs.is_empty() {
        return Err(Refused::Form { why: "it has no pairs" });
    }
    let longest = pairs.iter().map(|pair| pair.u.len().max(pair.v.len())).max().unwrap_or(0);
    at_most(longest, LETTERS, "letters in a word")?;
    at_most(pairs.iter().map(|pair| pair.u.len() + pair.v.len()).sum(), TEXT, "letters")?;
    Ok(longest)
}

/// Roughly how long it will take: numbers grow by `bits` digits and more a letter.
fn check_work(certificate: &Certificate, scene: &Scene) -> Result<(), Refused> {
    let size = |whole: u64, numbers: &mut dyn Iterator<Item = &BigInt>| {
        whole.max(numbers.map(BigInt::bits).max().unwrap_or(0)) / 64 + 2
    };
    let a_letter = size(scene.maps.bits, &mut scene.maps.rows.iter().flatten());
    let a_corner = size(scene.corners.bits, &mut scene.corners.rows.iter().flatten());
    let corners = certificate.polygon.len() as u64;
    let of_word = |letters: usize| {
        let letters = letters as u64;
        let end = letters * a_letter + 2 * a_corner;
        letters * end * 3 * a_letter + end * 2 * corners * a_corner
    };
    let blocks = (certificate.maps.len() as u64).pow(certificate.letters as u32);
    let inside = of_word(certificate.letters).saturating_mul(blocks).saturating_mul(corners);
    let convex = (corners * a_corner).pow(2);
    let pairs = certificate.pairs.iter().map(|pair| of_word(pair.u.len()) + of_word(pair.v.len()));
    let work = pairs.fold(inside.saturating_add(convex), u64::saturating_add);
    if work > WORK { Err(Refused::TooLarge { what: "digits to multiply", most: WORK }) } else { Ok(()) }
}

fn check_cut(side: &[u8]) -> Result<(), Refused> {
    if side.iter().any(|&s| s > 1) {
        return Err(Refused::Cut { why: "a side is neither 0 nor 1" });
    }
    for wanted in [0, 1] {
        if !side.contains(&wanted) {
            return Err(Refused::Cut { why: "all maps are on one side" });
        }
    }
    Ok(())
}

/// All words of some letters.
fn words(maps: usize, letters: usize) -> impl Iterator<Item = Vec<u8>> {
    let count = maps.pow(letters as u32);
    (0..count).map(move |mut k| {
        (0..letters)
            .map(|_| {
                let letter = k % maps;
                k /= maps;
                letter as u8
            })
            .collect()
    })
}
