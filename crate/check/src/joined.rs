//! The check that an attractor is in one piece.

use std::fmt;

use num_bigint::BigInt;

use crate::connected::{Address, ConnectedCertificate, Link};
use crate::crossing::{cost_across, lie_across};
use crate::difference::Differences;
use crate::limits::{CELLS, CORNERS, FARTHEST_CELL, LETTERS, MAPS, PAIRS, TEXT, at_most};
use crate::polygon::{Reach, Scene};
use crate::refused::Refused;
use crate::whole::Factor;
use crate::work::{WORK, Work, product};

/// What was checked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CheckedConnected {
    /// How many links between pieces hold.
    pub links: usize,
    /// Letters of the longest word.
    pub longest: usize,
}

impl fmt::Display for CheckedConnected {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self.links {
            0 => write!(f, "There is one map: checked in exact arithmetic."),
            1 => write!(f, "One link holds, and reaches every piece: checked in exact arithmetic."),
            links => write!(f, "All {links} links hold, and reach every piece: checked in exact arithmetic."),
        }
    }
}

/// Checks a certificate in exact arithmetic. What it proves is said in the [crate](crate).
///
/// # Errors
/// [`Refused`] with the first thing that is wrong with it, or that it is too large to be checked: more than 256 maps,
/// 512 corners, a million pairs or links, a hundred thousand squares, ten million letters, or words so long of numbers
/// with so many digits that it takes more than 20,000,000,000 multiplications of machine words. That is counted before
/// it begins.
pub fn check_connected(certificate: &ConnectedCertificate) -> Result<CheckedConnected, Refused> {
    check_connected_within(certificate, &Work::at_most(WORK))
}

/// The same with a meter of its own.
pub(crate) fn check_connected_within(
    certificate: &ConnectedCertificate,
    work: &Work,
) -> Result<CheckedConnected, Refused> {
    let ConnectedCertificate { maps, polygon, gap, near, links, squares, exact } = certificate;
    let longest = check_form(certificate)?;
    let exact = exact.as_ref();
    let mut scene = Scene::new(maps, polygon, work)?.with_exact(exact, maps, 1)?;
    let gap = Factor::of(*gap).filter(|_| *gap >= 0.0).ok_or(Refused::NotFinite { place: "gaps" })?;
    let differences = squares
        .as_ref()
        .map(|squares| Differences::new(&scene, squares).ok_or(Refused::Squares))
        .transpose()?;
    plan(certificate, &scene, differences.as_ref())?;
    scene.check_exact(exact, maps)?;
    scene.check_convex()?;
    for letter in 0..maps.len() {
        scene.check_inside(&[letter as u8])?;
    }
    if !gap.is_at_least_one() {
        check_gap(&scene, near, &gap)?;
    }
    if let Some(differences) = &differences
        && !differences.all_lead_back(&scene)?
    {
        return Err(Refused::Squares);
    }
    let mut reached = Reached::new(maps.len());
    let mut on_line = false;
    for (k, link) in links.iter().enumerate() {
        let (pair, why) = match link {
            Link::Point { addresses } => (
                addresses.each_ref().map(first),
                (!scene.coincide(addresses)?).then_some("its points are not the same"),
            ),
            Link::Area { pair } => {
                let pair = pair.map(usize::from);
                (pair, (!scene.fill(pair)?).then_some("the areas of its pieces leave room"))
            }
            Link::Difference { pair, steps } => {
                let pair = pair.map(usize::from);
                let meets = match &differences {
                    Some(differences) => differences.meet(&scene, pair, steps)?,
                    None => false,
                };
                (pair, (!meets).then_some("its step is not shown to be a difference of two points"))
            }
            Link::Between { addresses } => {
                on_line = on_line || scene.stays_on_line(addresses)?;
                let [p, _, r] = addresses.each_ref().map(first);
                let holds = on_line && scene.is_between(addresses)?;
                ([p, r], (!holds).then_some("its pieces are not shown to overlap on a line that holds all"))
            }
            Link::Crossing { words, far } => {
                let across = lie_across(&scene, words, far, &gap)?;
                let pair = words.each_ref().map(|word| usize::from(word[0]));
                (pair, (!across).then_some("its pieces do not lie across each other"))
            }
        };
        if let Some(why) = why {
            return Err(Refused::Link { link: k, why });
        }
        reached.join(pair);
    }
    match reached.missing() {
        Some(map) => Err(Refused::Unreached { map }),
        None => Ok(CheckedConnected { links: links.len(), longest }),
    }
}

fn first(address: &Address) -> usize {
    usize::from(*address.head.first().unwrap_or(&address.repeat[0]))
}

/// Sizes and forms; the letters of the longest word.
fn check_form(certificate: &ConnectedCertificate) -> Result<usize, Refused> {
    let ConnectedCertificate { maps, polygon, near, links, squares, exact, .. } = certificate;
    let cells = squares.as_ref().map_or(&[][..], |squares| &squares.cells);
    at_most(cells.len(), CELLS, "squares")?;
    at_most(maps.len(), MAPS, "maps")?;
    at_most(polygon.len(), CORNERS, "corners")?;
    at_most(near.len(), PAIRS, "pairs")?;
    at_most(links.len(), PAIRS, "links")?;
    let is_difference = |link: &Link| matches!(link, Link::Difference { .. });
    if exact.is_some() && (squares.is_some() || links.iter().any(is_difference)) {
        return Err(Refused::Form {
            why: "links of the kind \"difference\" are not checked of exact numbers",
        });
    }
    if maps.is_empty() {
        return Err(Refused::Form { why: "it has no maps" });
    }
    if polygon.len() < 3 {
        return Err(Refused::Form { why: "its polygon has fewer than three corners" });
    }
    let is_known = |letters: &[u8]| letters.iter().all(|&letter| usize::from(letter) < maps.len());
    let is_word = |word: &[u8]| !word.is_empty() && is_known(word);
    if !near.iter().flatten().all(|word| is_word(word)) {
        return Err(Refused::Form {
            why: "a word of pieces that are near is empty, or has a letter that is no map",
        });
    }
    // Far from the ends of the numbers that count squares.
    let is_cell = |&(x, y, k, l): &(i32, i32, u8, u8)| {
        x.unsigned_abs().max(y.unsigned_abs()) < FARTHEST_CELL && is_known(&[k, l])
    };
    if !cells.iter().all(is_cell) {
        return Err(Refused::Form { why: "a square is too far away, or names a map that is none" });
    }
    let (mut longest, mut letters) = (0, 0);
    let mut count = |word: usize| {
        longest = longest.max(word);
        letters += word;
    };
    near.iter().flatten().for_each(|word| count(word.len()));
    for link in links {
        let is_one = match link {
            Link::Point { addresses } => addresses.iter().all(|Address { head, repeat }| {
                count(head.len() + repeat.len());
                is_known(head) && is_word(repeat)
            }),
            Link::Between { addresses } => {
                let are_known = addresses.iter().all(|Address { head, repeat }| {
                    count(head.len() + repeat.len());
                    is_known(head) && is_word(repeat)
                });
                are_known && first(&addresses[0]) == first(&addresses[1])
            }
            Link::Area { pair } => pair[0] != pair[1] && is_known(pair),
            Link::Difference { pair, steps } => {
                count(steps.len());
                is_known(pair) && steps.iter().all(|step| is_known(step))
            }
            Link::Crossing { words, far } => {
                far.iter().enumerate().for_each(|(k, far)| count(words[k / 2].len() + far.tail.len()));
                words.iter().all(|word| is_word(word)) && far.iter().all(|far| is_known(&far.tail))
            }
        };
        if !is_one {
            return Err(Refused::Form { why: "a word of a link is empty, or has a letter that is no map" });
        }
    }
    at_most(longest, LETTERS, "letters in a word")?;
    at_most(letters, TEXT, "letters")?;
    Ok(longest)
}

/// What it takes at the most: refuses what is too large before it begins.
fn plan(
    certificate: &ConnectedCertificate,
    scene: &Scene,
    differences: Option<&Differences>,
) -> Result<(), Refused> {
    let ConnectedCertificate { maps, near, links, exact, .. } = certificate;
    let work = scene.work.afresh();
    work.spend(scene.cost_exact(exact.as_ref(), maps)?)?;
    work.spend(scene.cost_convex())?;
    work.spend((maps.len() as u64).saturating_mul(scene.cost_inside(1)))?;
    work.spend(scene.cost_edges())?;
    for words in near {
        work.spend(scene.cost_near(words))?;
    }
    work.spend(differences.map_or(0, |differences| differences.cost_all(scene)))?;
    let mut on_line = false;
    for link in links {
        work.spend(match link {
            Link::Point { addresses } => scene.cost_coincide(addresses),
            Link::Area { .. } => scene.cost_fill(),
            Link::Difference { steps, .. } => differences.map_or(0, |all| all.cost_meet(scene, steps.len())),
            Link::Between { addresses } => {
                // The line is looked at once.
                let line = if on_line { 0 } else { scene.cost_line(addresses) };
                on_line = true;
                line.saturating_add(scene.cost_between(addresses))
            }
            Link::Crossing { words, far } => cost_across(scene, words, far)?,
        })?;
    }
    Ok(())
}

/// Checks that no gap is wider: a spanning tree of pieces that are as near.
fn check_gap(scene: &Scene, near: &[[Vec<u8>; 2]], gap: &Factor) -> Result<(), Refused> {
    let edges = scene.edges(gap)?;
    let mut reached = Reached::new(scene.maps.rows.len());
    for words in near {
        if !scene.are_near(words, &edges)? {
            return Err(Refused::Gap { why: "two pieces are not as near as that" });
        }
        reached.join(words.each_ref().map(|word| usize::from(word[0])));
    }
    match reached.missing() {
        Some(_) => Err(Refused::Gap { why: "the pieces that are near do not reach all maps" }),
        None => Ok(()),
    }
}

/// The directions across an edge, out of the polygon and back, and how far points within the gap may lie apart there.
struct Edge {
    there: [BigInt; 2],
    back: [BigInt; 2],
    most: Reach,
}

impl Scene<'_> {
    /// What [`Self::edges`] takes.
    fn cost_edges(&self) -> u64 {
        (self.corners.rows.len() as u64).saturating_mul(2 * self.cost_farthest(self.corner, 0))
    }

    /// The edges of the polygon, each with `gap` times its width there.
    fn edges(&self, gap: &Factor) -> Result<Vec<Edge>, Refused> {
        let corners = &self.corners.rows;
        let across = |edge: usize| {
            let ([x, y], [next_x, next_y]) = (&corners[edge], &corners[(edge + 1) % corners.len()]);
            let there = [next_y - y, x - next_x];
            let back = there.clone().map(|x| -x);
            let to = |normal: &[BigInt; 2]| self.farthest(&[], normal.clone(), self.corners.bits);
            let most = to(&there)?.plus(&to(&back)?).times(gap);
            Ok(Edge { there, back, most })
        };
        (0..corners.len()).map(across).collect()
    }

    /// What [`Self::are_near`] takes.
    fn cost_near(&self, words: &[Vec<u8>; 2]) -> u64 {
        let [a, b] = words.each_ref().map(|word| self.cost_farthest(self.corner, word.len()));
        (self.corners.rows.len() as u64).saturating_mul(a.saturating_add(b).saturating_mul(2))
    }

    /// Whether no point of a piece is farther from one of another than the gap, in the norm whose unit ball is the
    /// polygon less itself: in each direction across an edge, not more than so many times the polygon's width.
    fn are_near(&self, [a, b]: &[Vec<u8>; 2], edges: &[Edge]) -> Result<bool, Refused> {
        for Edge { there, back, most } in edges {
            let to =
                |word: &[u8], normal: &[BigInt; 2]| self.farthest(word, normal.clone(), self.corners.bits);
            if most.is_below(&to(a, there)?.plus(&to(b, back)?))
                || most.is_below(&to(a, back)?.plus(&to(b, there)?))
            {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// What [`Self::fill`] takes.
    fn cost_fill(&self) -> u64 {
        match &self.exact {
            Some((field, _)) => field.cost_fill(),
            None => 6 * product(self.letter, self.letter),
        }
    }

    /// Whether two maps scale areas by factors with a sum of 1 or more.
    fn fill(&self, pair: [usize; 2]) -> Result<bool, Refused> {
        self.work.spend(self.cost_fill())?;
        if let Some((field, _)) = &self.exact {
            return Ok(field.fill(pair));
        }
        let area = |k: usize| {
            let [a, b, c, d, ..] = &self.maps.rows[k];
            (a * d - b * c).magnitude().clone()
        };
        Ok(area(pair[0]) + area(pair[1]) >= BigInt::from(1).magnitude() << (2 * self.maps.bits))
    }
}

/// Which maps hang together.
struct Reached {
    /// The number of each one's part.
    part: Vec<usize>,
}

impl Reached {
    fn new(count: usize) -> Self {
        Self { part: (0..count).collect() }
    }

    fn join(&mut self, [i, j]: [usize; 2]) {
        let (from, to) = (self.part[i], self.part[j]);
        // So that all links together rename a part as often as there are maps, at the most.
        if from == to {
            return;
        }
        for part in self.part.iter_mut().filter(|part| **part == from) {
            *part = to;
        }
    }

    /// A map that is not in the part of the first.
    fn missing(&self) -> Option<usize> {
        self.part.iter().position(|&part| part != self.part[0])
    }
}
