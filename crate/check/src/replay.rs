//! The check.

use std::fmt;

use crate::certificate::{Certificate, Pair};
use crate::cover::{check_cover, cost_cover};
use crate::limits::{CORNERS, LETTERS, MAPS, PAIRS, TEXT, at_most};
use crate::polygon::Scene;
use crate::refused::Refused;
use crate::whole::Whole;
use crate::work::{WORK, Work, digits};

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

/// Words that map the polygon into itself.
const BLOCKS: usize = 4096;

/// Checks a certificate in exact arithmetic. What it proves is said in the [crate](crate).
///
/// # Errors
/// [`Refused`] with the first thing that is wrong with it, or that it is too large to be checked: more than 256 maps,
/// 512 corners, a million pairs, ten million letters, or words so long of numbers with so many digits that it takes
/// more than 20,000,000,000 multiplications of machine words. That is counted before it begins.
///
/// ```
/// # use frond_check::{Certificate, Refused, check};
/// let none = Certificate { maps: vec![], polygon: vec![], letters: 1, side: vec![], pairs: vec![], exact: None };
/// assert_eq!(check(&none).unwrap_err().code(), "form");
/// ```
pub fn check(certificate: &Certificate) -> Result<Checked, Refused> {
    check_within(certificate, &Work::at_most(WORK))
}

/// The same with a meter of its own.
pub(crate) fn check_within(certificate: &Certificate, work: &Work) -> Result<Checked, Refused> {
    let Certificate { maps, polygon, letters, side, pairs, exact } = certificate;
    let longest = check_form(certificate)?;
    let exact = exact.as_ref();
    let mut scene = Scene::new(maps, polygon, work)?.with_exact(exact, maps, *letters)?;
    plan(certificate, &scene)?;
    scene.check_exact(exact, maps)?;
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
    check_cover(certificate, work)?;
    for (k, Pair { u, v, normal }) in pairs.iter().enumerate() {
        let whole = direction(*normal)?;
        let [n_x, n_y] = &whole.rows[0];
        // The least along `n` is less the greatest along `-n`.
        let most = scene.farthest(u, [n_x.clone(), n_y.clone()], whole.bits)?;
        let least = scene.farthest(v, [-n_x, -n_y], whole.bits)?.negative();
        if !most.is_below(&least) {
            return Err(Refused::NotApart { pair: k, u: u.clone(), v: v.clone() });
        }
    }
    Ok(Checked { pairs: pairs.len(), longest })
}

fn direction(normal: [f64; 2]) -> Result<Whole<2>, Refused> {
    Whole::of(&[normal]).ok_or(Refused::NotFinite { place: "directions" })
}

/// Sizes and forms; the letters of the longest word.
fn check_form(certificate: &Certificate) -> Result<usize, Refused> {
    let Certificate { maps, polygon, letters, side, pairs, .. } = certificate;
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

/// What it takes at the most: refuses what is too large before it begins.
fn plan(certificate: &Certificate, scene: &Scene) -> Result<(), Refused> {
    let Certificate { maps, letters, pairs, exact, .. } = certificate;
    let work = scene.work.afresh();
    work.spend(scene.cost_exact(exact.as_ref(), maps)?)?;
    work.spend(scene.cost_convex())?;
    let blocks = (maps.len() as u64).pow(*letters as u32);
    work.spend(blocks.saturating_mul(scene.cost_inside(*letters)))?;
    work.spend(cost_cover(certificate))?;
    for Pair { u, v, normal } in pairs {
        let normal = digits(&direction(*normal)?.rows[0]);
        work.spend(scene.cost_farthest(normal, u.len()))?;
        work.spend(scene.cost_farthest(normal, v.len()))?;
    }
    Ok(())
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
