//! Proofs about exact numbers that doubles stand for.

use frond_check::{Exact, ExactEntry, Refused};
use frond_core::{Affine2, Ifs};
use frond_exact::{ExactError, ExactNumbers, ExactRows, meeting};
use glam::DVec2;
use thiserror::Error;

use crate::evidence::certificate::certificate;
use crate::evidence::connected_certificate::{
    CertifiedLink, ConnectedCertificate, Meant, certified_as_meant,
};
use crate::evidence::reason::{Link, LinkKind, Reason};
use crate::exact::address::{Address, shown};
use crate::exact::area;
use crate::verdict::{Options, ReasonKind};

/// What is proved of maps with exact numbers. Each certificate was replayed by the crate `frond-check`.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum ExactProof {
    /// The attractor is in one piece.
    Connected {
        /// What shows it.
        reason: Reason,
        /// The proof to hand on.
        certificate: Box<frond_check::ConnectedCertificate>,
    },
    /// It is in several.
    Disconnected {
        /// The proof to hand on.
        certificate: Box<frond_check::Certificate>,
    },
    /// Neither is proved.
    Undecided(Unproved),
}

/// Why nothing is proved of maps with exact numbers.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum Unproved {
    /// The maps are not seen to have an attractor.
    #[error("The maps are not seen to have an attractor.")]
    NoAttractor,
    /// The numbers are too many or too large to be computed with.
    #[error("The numbers cannot be computed with exactly: {0}.")]
    Numbers(ExactError),
    /// A proof was found, and is not accepted: the crate is wrong somewhere.
    #[error("A proof was found, but a second program does not accept it: {0}")]
    Refused(Refused),
    /// Some pieces do not meet, which is known from all pairs of pieces; but no proof to hand on was found.
    #[error("Some pieces do not meet, but no proof was found that a second program can replay.")]
    Apart,
    /// The pieces meet, which is known from pairs of pieces; but no proof to hand on was found.
    #[error("The pieces meet, but no proof was found that a second program can replay.")]
    Meeting,
    /// Too many pairs of pieces may meet.
    #[error("No proof was found within the pairs of pieces that were looked at.")]
    Budget,
}

impl Unproved {
    /// A name that stays the same over versions, for programs.
    #[must_use]
    pub const fn name(&self) -> &'static str {
        match self {
            Self::NoAttractor => "no-attractor",
            Self::Numbers(_) => "numbers",
            Self::Refused(_) => "refused",
            Self::Apart => "apart",
            Self::Meeting => "meeting",
            Self::Budget => "budget",
        }
    }
}

/// Proves that the attractor of maps is in one piece or in several, where some doubles of their rows stand for exact
/// numbers. At most `budget` pairs of pieces are looked at exactly, besides what the options say.
///
/// ```
/// use frond_exact::ExactNumbers;
/// use frond_locus::{ExactProof, Options, prove_exact};
///
/// // Three thirds of a segment.
/// let third = 1.0 / 3.0;
/// let rows = [0.0, third, 2.0 / 3.0].map(|e| [third, 0.0, 0.0, third, e, 0.0]);
/// let numbers = ExactNumbers::read(&["1/3", "2/3"]).unwrap();
/// let found = prove_exact(&rows, &numbers, &Options::default(), 20_000);
/// assert!(matches!(found, ExactProof::Connected { .. }));
/// ```
#[must_use]
pub fn prove_exact(
    rows: &[[f64; 6]],
    numbers: &ExactNumbers,
    options: &Options,
    budget: usize,
) -> ExactProof {
    let exact = match numbers.rows(rows) {
        Ok(exact) => exact,
        Err(error) => return ExactProof::Undecided(Unproved::Numbers(error)),
    };
    let maps = rows.iter().copied().map(Affine2::from_row).collect();
    let Ok(ifs) = Ifs::new(maps) else { return ExactProof::Undecided(Unproved::NoAttractor) };
    let Some(form) = form(&exact) else { return ExactProof::Undecided(Unproved::NoAttractor) };
    let mut refused = None;
    let mut connected = |shared: &[(Address, Address)]| {
        let found = certified_as_meant(&ifs, options, &Meant { exact: &exact, shared })?;
        let reason = reason(ifs.maps(), &found);
        let mut certificate = frond_check::ConnectedCertificate::from(found);
        certificate.exact = form.clone();
        match frond_check::check_connected(&certificate) {
            Ok(_) => Some(ExactProof::Connected { reason, certificate: Box::new(certificate) }),
            Err(error) => {
                refused = Some(error);
                None
            }
        }
    };
    if let Some(proof) = connected(&[]) {
        return proof;
    }
    let disconnected = |options: &Options| {
        let mut certificate = frond_check::Certificate::from(certificate(&ifs, options)?);
        certificate.exact = form.clone();
        let is_accepted = frond_check::check(&certificate).is_ok();
        is_accepted.then(|| ExactProof::Disconnected { certificate: Box::new(certificate) })
    };
    if let Some(proof) = disconnected(options) {
        return proof;
    }
    let found = exact.system().and_then(|system| meeting(&system, budget, |_| true));
    let Ok(found) = found else {
        return ExactProof::Undecided(refused.map_or(Unproved::Budget, Unproved::Refused));
    };
    if found.count() > 1 {
        if !found.is_complete {
            return ExactProof::Undecided(Unproved::Budget);
        }
        // Pieces that are apart by very little.
        let closer = Options { epsilon: 0.0, budget: options.budget.max(Options::default().budget) };
        return disconnected(&closer).unwrap_or(ExactProof::Undecided(Unproved::Apart));
    }
    let letters = |word: &[usize]| word.iter().map(|&letter| letter as u8).collect();
    let address =
        |address: &frond_exact::Address| Address::new(letters(&address.head), letters(&address.repeat));
    let shared = found.points.iter().filter_map(|point| {
        let [a, b] = point.addresses.each_ref().map(address);
        Some((a?, b?))
    });
    let shared: Vec<_> = shared.collect();
    let proof = connected(&shared);
    proof.unwrap_or_else(|| ExactProof::Undecided(refused.map_or(Unproved::Meeting, Unproved::Refused)))
}

/// The numbers that are not their doubles, for those who check; `None` inside where there is none.
fn form(exact: &ExactRows) -> Option<Option<Exact>> {
    if exact.named().is_empty() {
        return Some(None);
    }
    let entries = exact.named().iter().map(|&(map, entry)| {
        let value = exact.rows()[map][entry].coefficients();
        let length = value.iter().rposition(|x| !x.is_zero()).map_or(1, |last| last + 1);
        ExactEntry {
            map: map as u8,
            entry: entry as u8,
            value: value[..length].iter().map(ToString::to_string).collect(),
        }
    });
    Some(Some(Exact {
        polynomial: exact.field().polynomial().iter().map(ToString::to_string).collect(),
        root: exact.root_within()?.map(|end| end.to_string()),
        entries: entries.collect(),
    }))
}

/// What a certificate says, to be shown.
fn reason(maps: &[Affine2], found: &ConnectedCertificate) -> Reason {
    let count = maps.len();
    if let Some(kind) = area::kind(maps).filter(|kind| *kind != ReasonKind::Area) {
        return Reason::of(kind);
    }
    let point = |[head, repeat]: &[Vec<u8>; 2]| Address { head: head.clone(), repeat: repeat.clone() };
    let within = |word: &[u8], tail: &[u8]| {
        let start = maps[usize::from(word[0])].fixed_point().unwrap_or(DVec2::ZERO);
        let letters = word.iter().chain(tail).rev();
        letters.fold(start, |point, letter| maps[usize::from(*letter)].apply(point))
    };
    let link = |link: &CertifiedLink| {
        let named = |kind, pair: [u8; 2], at, corners| {
            let pair = pair.map(usize::from);
            let words = pair.map(|map| shown(&[map as u8], count));
            Link { kind, pair: (pair[0].min(pair[1]), pair[0].max(pair[1])), words, at, corners }
        };
        let between = |pair: [u8; 2]| {
            let [a, b] = pair.map(|map| within(&[map], &[map]));
            a.midpoint(b)
        };
        match link {
            CertifiedLink::Point(addresses) => {
                let both = addresses.each_ref().map(point);
                let at = both[0].point(maps).unwrap_or(DVec2::ZERO);
                let firsts = both.each_ref().map(|address| address.first() as u8);
                let words = both.each_ref().map(|address| address.shown(count));
                Link { words, ..named(LinkKind::Point, firsts, at, Vec::new()) }
            }
            CertifiedLink::Between(addresses) => {
                let all = addresses.each_ref().map(point);
                let firsts = [all[0].first() as u8, all[2].first() as u8];
                let at = all[2].point(maps).unwrap_or(DVec2::ZERO);
                named(LinkKind::Line, firsts, at, Vec::new())
            }
            CertifiedLink::Area(pair) => named(LinkKind::Area, *pair, between(*pair), Vec::new()),
            CertifiedLink::Difference(pair, _) => {
                named(LinkKind::Difference, *pair, between(*pair), Vec::new())
            }
            CertifiedLink::Crossing(words, far) => {
                let corners = [0, 1, 2, 3].map(|k: usize| within(&words[k / 2], &far[k].tail));
                let at = corners.iter().sum::<DVec2>() / 4.0;
                let pair = words.each_ref().map(|word| word[0]);
                let words = words.each_ref().map(|word| shown(word, count));
                Link { words, ..named(LinkKind::Crossing, pair, at, corners.to_vec()) }
            }
        }
    };
    let mut links: Vec<Link> = found.links.iter().map(link).collect();
    links.sort_by_key(|link| link.pair);
    let has = |kind| links.iter().any(|link| link.kind == kind);
    let kind = if has(LinkKind::Crossing) {
        ReasonKind::Crossings
    } else if has(LinkKind::Line) {
        ReasonKind::Line
    } else if has(LinkKind::Difference) {
        ReasonKind::Differences
    } else if has(LinkKind::Area) {
        ReasonKind::Area
    } else {
        ReasonKind::SharedPoints
    };
    Reason { links, ..Reason::of(kind) }
}
