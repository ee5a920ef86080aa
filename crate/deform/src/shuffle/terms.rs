//! Which terms a bend has, and what each counts.

use glam::DVec2;

use crate::mesh::Mesh;
use crate::settings::Roughness;
use crate::shuffle::spin::Spin;
use crate::shuffle::weight::weigh;

/// The deepest letter that is shuffled.
pub(crate) const DEEPEST: usize = 64;

/// The deepest level of a shape of so many maps that has no more cells than this.
pub(crate) fn deepest_level(maps: usize, most_cells: usize) -> usize {
    if maps < 2 {
        return 32;
    }
    let (mut depth, mut cells) = (0, maps);
    while cells <= most_cells {
        cells *= maps;
        depth += 1;
    }
    depth
}

/// The terms of a superposition between whole numbers (Fujimoto et al., eqs 12 and 19). Between four whole pairs of
/// kb and ke a bend is a bilinear blend; those with one kb have their terms in common, so that there are two families
/// of terms at most.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Terms {
    pub families: Vec<Family>,
    /// The roughness and, where it is the same all over, the weights of the families one after another.
    roughness: Roughness,
    fixed: Option<Weights>,
    superposed: bool,
}

/// The terms that leave the first `kb` letters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Family {
    pub kb: usize,
    /// The first term that is not the plain displacement, and one after the last with a weight.
    pub first: usize,
    pub end: usize,
    /// The sums that it takes part in: their ke and what they count.
    sums: [(usize, f64); 2],
    /// Where the weight of its first term stands in [`Weights`].
    at: usize,
}

impl Family {
    /// Where the weight of term k stands.
    pub const fn slot(&self, k: usize) -> usize {
        self.at + k - self.first
    }
}

/// What each term counts at some point: the plain displacement, and all others.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Weights {
    pub plain: f64,
    pub list: [f64; 2 * DEEPEST + 4],
}

impl Terms {
    /// `ke` must not be beyond [`DEEPEST`].
    pub fn new(kb: f64, ke: f64, roughness: Roughness, spin: Spin, superposed: bool) -> Self {
        let ke = ke.clamp(0.0, DEEPEST as f64);
        let kb = kb.clamp(0.0, ke);
        let (b, rb, e, re) = (kb.floor() as usize, kb.fract(), ke.floor() as usize, ke.fract());
        // Turned displacements jump between pieces from the first shuffled letter on.
        let exact = if spin == Spin::None { 2 } else { 1 };
        let mut families: Vec<Family> = Vec::new();
        let mut at = 0;
        for (kb, share) in [(b, 1.0 - rb), (b + 1, rb)] {
            let sums = [(e.max(kb), share * (1.0 - re)), ((e + 1).max(kb), share * re)];
            if share > 0.0 {
                let last = if re > 0.0 { sums[1].0 } else { sums[0].0 };
                let (first, end) = (kb + exact, (last + 1).max(kb + exact));
                families.push(Family { kb, first, end, sums, at });
                at += end - first;
            }
        }
        let mut this = Self { families, roughness, fixed: None, superposed };
        this.fixed = roughness.constant().map(|delta| this.with(delta));
        this
    }

    /// The word length from on which everything is smooth.
    pub fn depth(&self) -> usize {
        self.families.iter().filter(|f| f.end > f.first).map(|f| f.end - 1).max().unwrap_or(0)
    }

    /// The families that have a term of k.
    pub fn families_at(&self, k: usize) -> impl Iterator<Item = &Family> {
        self.families.iter().filter(move |family| (family.first..family.end).contains(&k))
    }

    /// What the terms count at a point at rest; `room` is where it is put if it is not the same all over.
    #[inline]
    pub fn at<'a>(&'a self, mesh: &Mesh, point: DVec2, room: &'a mut Option<Weights>) -> &'a Weights {
        match &self.fixed {
            Some(weights) => weights,
            None => room.insert(self.with(self.roughness.at(mesh, point))),
        }
    }

    /// What one term counts at a point at rest.
    #[inline]
    pub fn weight(&self, family: &Family, k: usize, mesh: &Mesh, point: DVec2) -> f64 {
        self.at(mesh, point, &mut None).list[family.slot(k)]
    }

    /// The weights where they are the same all over.
    pub const fn fixed(&self) -> Option<&Weights> {
        self.fixed.as_ref()
    }

    fn with(&self, delta: f64) -> Weights {
        let mut weights = Weights { plain: 0.0, list: [0.0; 2 * DEEPEST + 4] };
        let mut powers = [0.0; DEEPEST + 2];
        for family in &self.families {
            for (ke, share) in family.sums.into_iter().filter(|(_, share)| *share > 0.0) {
                let powers = &mut powers[..=ke - family.kb];
                if self.superposed {
                    weigh(delta, powers);
                } else {
                    powers.fill(0.0);
                    powers.iter_mut().rev().take(1).for_each(|last| *last = 1.0);
                }
                for (k, power) in (family.kb..).zip(&*powers) {
                    let slot =
                        if k < family.first { &mut weights.plain } else { &mut weights.list[family.slot(k)] };
                    *slot += share * power;
                }
            }
        }
        weights
    }
}
