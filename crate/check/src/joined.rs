//! The check that an attractor is in one piece.

use std::fmt;

use num_bigint::BigInt;

use crate::connected::{Address, ConnectedCertificate, Link};
use crate::crossing::lie_across;
use crate::difference::Differences;
use crate::limits::{CELLS, CORNERS, FARTHEST_CELL, LETTERS, MAPS, PAIRS, TEXT, Work, at_most};
use crate::polygon::Scene;
use crate::refused::Refused;
use crate::whole::{Factor, Whole};

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
/// 512 corners, a million pairs or links, ten million letters.
pub fn check_connected(certificate: &ConnectedCertificate) -> Result<CheckedConnected, Refused> {
    let ConnectedCertificate { maps, polygon, gap, near, links, squares } = certificate;
    let longest = check_form(certificate)?;
    let scene = Scene {
        maps: Whole::of(maps).ok_or(Refused::NotFinite { place: "maps" })?,
        corners: Whole::of(polygon).ok_or(Refused::NotFinite { place: "corners" })?,
    };
    let gap = Factor::of(*gap).filter(|_| *gap >= 0.0).ok_or(Refused::NotFinite { place: "gaps" })?;
    check_work(certificate, &scene)?;
    scene.check_convex()?;
    for letter in 0..maps.len() {
        scene.check_inside(&[letter as u8])?;
    }
    if !gap.is_at_least_one() {
        check_gap(&scene, near, &gap)?;
    }
    let differences = squares.as_ref().and_then(|squares| Differences::new(&scene, squares));
    let differences = differences.filter(|differences| differences.all_lead_back(&scene));
    if squares.is_some() && differences.is_none() {
        return Err(Refused::Squares);
    }
    let mut reached = Reached::new(maps.len());
    let mut on_line = false;
    for (k, link) in links.iter().enumerate() {
        let (pair, why) = match link {
            Link::Point { addresses } => (
                addresses.each_ref().map(first),
                (!scene.coincide(addresses)).then_some("its points are not the same"),
            ),
            Link::Area { pair } => {
                let pair = pair.map(usize::from);
                (pair, (!scene.fill(pair)).then_some("the areas of its pieces leave room"))
            }
            Link::Difference { pair, steps } => {
                let pair = pair.map(usize::from);
                let meets = differences.as_ref().is_some_and(|all| all.meet(&scene, pair, steps));
                (pair, (!meets).then_some("its step is not shown to be a difference of two points"))
            }
            Link::Between { addresses } => {
                on_line = on_line || scene.stays_on_line(addresses);
                let [p, _, r] = addresses.each_ref().map(first);
                let holds = on_line && scene.is_between(addresses);
                ([p, r], (!holds).then_some("its pieces are not shown to overlap on a line that holds all"))
            }
            Link::Crossing { words, far } => {
                let across =
                    lie_across(&scene, words, far, &gap).ok_or(Refused::NotFinite { place: "directions" })?;
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
    let ConnectedCertificate { maps, polygon, near, links, squares, .. } = certificate;
    let cells = squares.as_ref().map_or(&[][..], |squares| &squares.cells);
    at_most(cells.len(), CELLS, "squares")?;
    at_most(maps.len(), MAPS, "maps")?;
    at_most(polygon.len(), CORNERS, "corners")?;
    at_most(near.len(), PAIRS, "pairs")?;
    at_most(links.len(), PAIRS, "links")?;
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

/// Roughly how long it will take.
fn check_work(certificate: &ConnectedCertificate, scene: &Scene) -> Result<(), Refused> {
    let mut work = Work::of(scene);
    let corners = certificate.polygon.len() as u64;
    work.add(corners * certificate.maps.len() as u64, 1);
    work.add(certificate.squares.as_ref().map_or(0, |squares| squares.cells.len() as u64), 1);
    for [a, b] in &certificate.near {
        work.add(2 * corners, a.len());
        work.add(2 * corners, b.len());
    }
    for link in &certificate.links {
        match link {
            // Products of maps take fewer, but longer, multiplications than to follow a direction.
            Link::Point { addresses } => {
                for Address { head, repeat } in addresses {
                    work.add(10, head.len() + repeat.len());
                }
            }
            // The points, and those of the first two under each map.
            Link::Between { addresses } => {
                for Address { head, repeat } in addresses {
                    work.add(10 + certificate.maps.len() as u64, head.len() + repeat.len());
                }
            }
            Link::Area { .. } => work.add(1, 1),
            Link::Difference { steps, .. } => work.add(1, steps.len()),
            Link::Crossing { words, far } => {
                for (k, far) in far.iter().enumerate() {
                    work.add(1, words[k / 2].len() + far.tail.len());
                    work.add(2, words[1 - k / 2].len());
                }
            }
        }
    }
    work.check()
}

/// Checks that no gap is wider: a spanning tree of pieces that are as near.
fn check_gap(scene: &Scene, near: &[[Vec<u8>; 2]], gap: &Factor) -> Result<(), Refused> {
    let mut reached = Reached::new(scene.maps.rows.len());
    for words in near {
        if !scene.are_near(words, gap) {
            return Err(Refused::Gap { why: "two pieces are not as near as that" });
        }
        reached.join(words.each_ref().map(|word| usize::from(word[0])));
    }
    match reached.missing() {
        Some(_) => Err(Refused::Gap { why: "the pieces that are near do not reach all maps" }),
        None => Ok(()),
    }
}

impl Scene {
    /// Whether no point of a piece is farther from one of another than `gap`, in the norm whose unit ball is the
    /// polygon less itself: in each direction across an edge, not more than so many times the polygon's width.
    fn are_near(&self, [a, b]: &[Vec<u8>; 2], gap: &Factor) -> bool {
        let corners = &self.corners.rows;
        let bits = self.corners.bits;
        (0..corners.len()).all(|edge| {
            let ([x, y], [next_x, next_y]) = (&corners[edge], &corners[(edge + 1) % corners.len()]);
            let there = [next_y - y, x - next_x];
            let back = there.clone().map(|x| -x);
            let to = |word: &[u8], normal: &[BigInt; 2]| self.farthest(word, normal.clone(), bits);
            let most = to(&[], &there).plus(&to(&[], &back)).times(gap);
            !most.is_below(&to(a, &there).plus(&to(b, &back)))
                && !most.is_below(&to(a, &back).plus(&to(b, &there)))
        })
    }

    /// Whether two maps scale areas by factors with a sum of 1 or more.
    fn fill(&self, pair: [usize; 2]) -> bool {
        let area = |k: usize| {
            let [a, b, c, d, ..] = &self.maps.rows[k];
            (a * d - b * c).magnitude().clone()
        };
        area(pair[0]) + area(pair[1]) >= BigInt::from(1).magnitude() << (2 * self.maps.bits)
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
        for part in self.part.iter_mut().filter(|part| **part == from) {
            *part = to;
        }
    }

    /// A map that is not in the part of the first.
    fn missing(&self) -> Option<usize> {
        self.part.iter().position(|&part| part != self.part[0])
    }
}
