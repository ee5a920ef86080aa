//! The curve at one moment of a morph.

use glam::{DMat2, DVec2};

use super::knot_ring::{Ring, Rough};
use crate::closed::{CONTRACTION, complex};
use crate::fractal::piece::spectral_norm;

/// The most copies that are opened for one point.
const MOST_OPENED: u32 = 1 << 16;

/// What is left out of a point, in parts of the box.
const POINT_ERROR: f64 = 1e-15;

/// One copy that an edge is made with: the arc's residual, times a matrix.
#[derive(Clone, Copy, Debug)]
pub(super) struct Term {
    pub linear: DMat2,
    pub norm: f64,
    /// Where the arc begins, and how long it is, by chords.
    pub low: f64,
    pub long: f64,
    pub flipped: bool,
    /// Where the end lies that the edge's beginning copies, and from there the chord.
    pub start: DVec2,
    pub chord: DVec2,
    /// The arc's indices of edges.
    pub from: usize,
    pub span: usize,
    /// No point of the arc is farther from its chord.
    pub reach: f64,
}

/// A closed curve of two copies an edge: knots, chords, and residuals of its own arcs.
#[derive(Clone, Debug)]
pub struct MorphedCurve {
    pub(super) knots: Vec<DVec2>,
    pub(super) places: Vec<f64>,
    pub(super) terms: Vec<[Option<Term>; 2]>,
    /// No point of an edge is farther from its chord, at the same share of both.
    pub(super) radii: Vec<f64>,
    pub(super) size: f64,
}

fn blend(a: f64, b: f64, s: f64) -> f64 {
    a * (1.0 - s) + b * s
}

impl MorphedCurve {
    pub(super) fn new(rings: &[Ring; 2], places: &[Vec<f64>; 2], s: f64) -> Self {
        let both = rings[0].knots.iter().zip(&rings[1].knots);
        let knots: Vec<DVec2> = both.map(|(a, b)| *a * (1.0 - s) + *b * s).collect();
        let places: Vec<f64> = places[0].iter().zip(&places[1]).map(|(&a, &b)| blend(a, b, s)).collect();
        let (low, high) = crate::outline::bounds(&knots);
        let count = knots.len();
        let mut morphed =
            Self { knots, places, terms: Vec::new(), radii: vec![0.0; count], size: low.distance(high) };
        morphed.terms = (0..count)
            .map(|i| {
                let term = |ring: &Ring, weight: f64| morphed.term(i, ring.edges[i].as_ref()?, weight);
                [term(&rings[0], 1.0 - s), term(&rings[1], s)]
            })
            .collect();
        morphed.measure();
        morphed
    }

    pub(super) fn knot(&self, index: usize) -> DVec2 {
        self.knots[index % self.knots.len()]
    }

    fn term(&self, edge: usize, rough: &Rough, weight: f64) -> Option<Term> {
        let count = self.knots.len();
        let end = (rough.from + rough.span) % count;
        let (first, last) = if rough.flipped { (end, rough.from) } else { (rough.from, end) };
        let start = self.knots[first];
        let chord = self.knots[last] - start;
        let own = self.knot(edge + 1) - self.knots[edge];
        let shape = DMat2::from_cols(DVec2::X, rough.shape);
        let ratio = own.length() / chord.length() * spectral_norm(shape);
        if weight <= 0.0 || own == DVec2::ZERO || chord.length_squared() <= f64::MIN_POSITIVE {
            return None;
        }
        // On the way a copy may be asked to grow: the more it is, the more it fades, so that nothing jumps where the
        // arc's chord passes through nothing.
        let fade = if ratio > CONTRACTION { (CONTRACTION / ratio).powi(2) } else { 1.0 };
        let back = DVec2::new(chord.x, -chord.y) / chord.length_squared();
        let linear = complex(own) * shape * complex(back) * (fade * weight);
        let low = self.places[rough.from];
        let wraps = rough.from + rough.span > count;
        let long =
            self.places[if wraps { end } else { rough.from + rough.span }] + f64::from(u8::from(wraps)) - low;
        let norm = spectral_norm(linear);
        let Rough { from, span, flipped, .. } = *rough;
        (norm.is_finite() && norm > 0.0).then_some(Term {
            linear,
            norm,
            low,
            long,
            flipped,
            start,
            chord,
            from,
            span,
            reach: 0.0,
        })
    }

    /// How far edges and arcs stray from their chords: the least numbers that agree with each other.
    fn measure(&mut self) {
        let count = self.knots.len();
        // How far the knots of each arc are off its chord, edge by edge.
        let off = |term: &Term| -> Vec<f64> {
            let distance = |k: usize| {
                let index = (term.from + k) % count;
                let wraps = f64::from(u8::from(term.from + k >= count && index <= term.from));
                let share =
                    if term.long > 0.0 { (self.places[index] + wraps - term.low) / term.long } else { 0.0 };
                let share = if term.flipped { 1.0 - share } else { share };
                self.knots[index].distance(term.start + term.chord * share)
            };
            (0..term.span)
                .map(|k| if k + 1 == term.span { distance(k) } else { distance(k).max(distance(k + 1)) })
                .collect()
        };
        let offs: Vec<[Vec<f64>; 2]> = self
            .terms
            .iter()
            .map(|pair| pair.each_ref().map(|term| term.as_ref().map_or(Vec::new(), &off)))
            .collect();
        let mut radii = vec![0.0_f64; count];
        for _ in 0..400 {
            let mut grown = 0.0_f64;
            for i in 0..count {
                let mut radius = 0.0;
                for (term, off) in self.terms[i].iter_mut().zip(&offs[i]) {
                    let Some(term) = term else { continue };
                    let reach = off.iter().enumerate().map(|(k, off)| off + radii[(term.from + k) % count]);
                    term.reach = reach.fold(0.0, f64::max);
                    radius += term.norm * term.reach;
                }
                grown = grown.max(radius - radii[i]);
                radii[i] = radius;
            }
            if grown <= 1e-9 * self.size {
                break;
            }
        }
        // What was left when the loop ended, ten times over.
        let rest = 1e-8 * self.size;
        radii.iter_mut().for_each(|radius| *radius += if *radius > 0.0 { rest } else { 0.0 });
        self.terms.iter_mut().flatten().flatten().for_each(|term| term.reach += rest);
        self.radii = radii;
    }

    /// The edge at a place, and how far along it is.
    pub(super) fn locate(&self, place: f64) -> (usize, f64) {
        let place = if (0.0..1.0).contains(&place) { place } else { place.rem_euclid(1.0) };
        let edge = self.places.partition_point(|&p| p <= place).clamp(1, self.knots.len()) - 1;
        let long = self.places[edge + 1] - self.places[edge];
        (edge, if long > 0.0 { ((place - self.places[edge]) / long).clamp(0.0, 1.0) } else { 0.0 })
    }

    /// The point at a place, but for `rest`; so many copies are opened at most, as many for each of two.
    pub(super) fn value(&self, place: f64, rest: f64, fuel: u32) -> DVec2 {
        let (edge, share) = self.locate(place);
        let chord = self.knot(edge + 1) - self.knots[edge];
        let mut point = self.knots[edge] + chord * share;
        if share == 0.0 {
            return point;
        }
        let needed = |term: &&Term| term.norm * term.reach > rest;
        let many = self.terms[edge].iter().flatten().filter(needed).count() as u32;
        if many > fuel {
            return point;
        }
        for term in self.terms[edge].iter().flatten().filter(needed) {
            let along = if term.flipped { 1.0 - share } else { share };
            let source = self.value(term.low + term.long * along, rest / term.norm, fuel / many - 1);
            point += term.linear * (source - (term.start + term.chord * share));
        }
        point
    }

    /// The point at t, from 0 to 1 by the lengths of chords; what is beyond goes round again. The first knot where t is
    /// not finite.
    #[must_use]
    pub fn point(&self, t: f64) -> DVec2 {
        if !t.is_finite() {
            return self.knots[0];
        }
        self.value(t, POINT_ERROR * self.size, MOST_OPENED)
    }

    /// The points at t = i / count, near enough for any picture: within a millionth of the box.
    #[must_use]
    pub fn grid(&self, count: usize) -> Vec<DVec2> {
        let place = |i: usize| i as f64 / count as f64;
        (0..count).map(|i| self.value(place(i), 1e-6 * self.size, MOST_OPENED)).collect()
    }

    /// How many copies there are.
    #[must_use]
    pub fn copies(&self) -> usize {
        self.terms.iter().flatten().flatten().count()
    }

    /// The largest norm of what an edge copies, both copies together: below 1, hence there is one curve.
    #[must_use]
    pub fn contraction(&self) -> f64 {
        let norm = |pair: &[Option<Term>; 2]| pair.iter().flatten().map(|term| term.norm).sum();
        self.terms.iter().map(norm).fold(0.0, f64::max)
    }
}
