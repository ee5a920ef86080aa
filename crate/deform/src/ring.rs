//! A closed curve bent by a mesh.

mod line;

use std::ops::{Add, Mul};

use glam::DVec2;

use crate::error::BendError;
use crate::mesh::Mesh;
use crate::settings::Settings;
use crate::shuffle::spin::Spin;
use crate::shuffle::terms::{Family, Terms};

/// Symbols of the code: digits of the parameter.
const SYMBOLS: usize = 4;

/// A fractal deformation of a closed curve at one moment (Fujimoto et al., eqs 12, 18 and 19).
///
/// The code of a point is its parameter t, from 0 to 1 around the curve, written in base 4: digit k names the quarter
/// of the quarter .. of the curve that the point is in. Term k gives it the displacement of the point whose digits kb +
/// 1 to k stand in reverse (eqs 5 and 6); the weights are those of eq 13.
///
/// Continuity is exact: a term that is shuffled is taken at the ends of the 4^k parts of length 4^-k, where two parts
/// meet it is the mean of both sides, and within a part it is linear in t. So the curve stays closed and has no gaps.
/// There is no other choice, and nothing turns with the parts of a curve: continuity and spin of the settings do not
/// count. Terms that are not shuffled are the plain displacement by the mesh, without any of this.
///
/// ```
/// use frond_deform::{Continuity, Mesh, RingBend, Roughness, Settings, Spin};
/// use glam::DVec2;
///
/// let settings = Settings {
///     kb: 0.0,
///     ke: 4.0,
///     roughness: Roughness::Constant(0.6),
///     spin: Spin::None,
///     continuity: Continuity::Auto,
///     superposed: true,
/// };
/// let count = RingBend::points(&settings)?;
/// let circle: Vec<_> =
///     (0..count).map(|i| DVec2::from_angle(std::f64::consts::TAU * i as f64 / count as f64)).collect();
/// let mut mesh = Mesh::at_rest(-DVec2::ONE, DVec2::ONE, 4, 4)?;
/// let mut bend = RingBend::new(mesh, settings, &circle)?;
/// let mut moves = vec![DVec2::ZERO; 16];
/// moves[5] = DVec2::new(0.0, 0.5);
/// bend.set_mesh(&moves)?;
/// let end = bend.displaced(1.0, circle[0]);
/// assert!(end.distance(bend.displaced(0.0, circle[0])) < 1e-12);
/// # Ok::<(), frond_deform::BendError>(())
/// ```
#[derive(Clone, Debug)]
pub struct RingBend {
    mesh: Mesh,
    terms: Terms,
    letters: usize,
    grid: Vec<DVec2>,
    /// What each shuffled term counts at the ends of its parts, where roughness is not the same all over.
    weights: Vec<Vec<f64>>,
    /// The numbers of the smallest parts with their digits in reverse.
    order: Vec<u32>,
    /// The sum of those weights, and of the shuffled terms, at the ends of the smallest parts.
    shares: Vec<f64>,
    values: Vec<DVec2>,
}

impl RingBend {
    /// The deepest digit that is shuffled: 262,144 parts. A greater detail counts as this.
    pub const DEEPEST: usize = 9;

    /// How many points of the curve a bend of these settings needs: 4^k for the deepest digit k that is shuffled, 1
    /// where none is.
    ///
    /// # Errors
    /// [`BendError`] for settings that are none.
    pub fn points(settings: &Settings) -> Result<usize, BendError> {
        settings.check()?;
        Ok(SYMBOLS.pow(Self::terms(settings, Self::DEEPEST).depth() as u32))
    }

    fn terms(settings: &Settings, deepest: usize) -> Terms {
        let &Settings { kb, ke, roughness, superposed, .. } = settings;
        Terms::new(kb, ke.min(deepest as f64), roughness, Spin::None, superposed)
    }

    /// The bend of the curve whose points at t = i / count are `grid`; count is a power of 4, 4^9 at most. Where it is
    /// less than [`points`](Self::points) says, the detail is taken down to it.
    ///
    /// # Errors
    /// [`BendError`]: for settings that are none, another count, and points that are not finite.
    pub fn new(mesh: Mesh, settings: Settings, grid: &[DVec2]) -> Result<Self, BendError> {
        settings.check()?;
        let count = grid.len();
        let given = (0..=Self::DEEPEST).find(|&letters| SYMBOLS.pow(letters as u32) == count);
        let (Some(given), true) = (given, grid.iter().all(|p| p.x.abs() <= 1e100 && p.y.abs() <= 1e100))
        else {
            return Err(BendError::Ring { count });
        };
        let mut terms = Self::terms(&settings, Self::DEEPEST);
        if terms.depth() > given {
            terms = Self::terms(&settings, given);
        }
        let letters = terms.depth();
        let grid: Vec<_> = grid.iter().step_by(SYMBOLS.pow((given - letters) as u32)).copied().collect();
        let order = reversed(letters);
        let (weights, shares, values) = (Vec::new(), Vec::new(), Vec::new());
        let mut this = Self { mesh, terms, letters, grid, weights, order, shares, values };
        if this.terms.fixed().is_none() {
            let levels = (1..=letters).flat_map(|k| this.terms.families_at(k).map(move |family| (family, k)));
            this.weights = levels.map(|(family, k)| this.weigh(family, k)).collect();
            this.shares = this.fill(0.0, |_, weight| weight);
        }
        this.refresh();
        Ok(this)
    }

    /// What a term counts at the ends of its parts.
    fn weigh(&self, family: &Family, k: usize) -> Vec<f64> {
        let step = SYMBOLS.pow((self.letters - k) as u32);
        self.grid.iter().step_by(step).map(|&p| self.terms.weight(family, k, &self.mesh, p)).collect()
    }

    /// Moves the control points: all that hangs on the curve alone is kept.
    ///
    /// # Errors
    /// [`BendError::Mesh`]; the bend is then as it was.
    pub fn set_mesh(&mut self, displacements: &[DVec2]) -> Result<(), BendError> {
        self.mesh = self.mesh.moved(displacements)?;
        self.refresh();
        Ok(())
    }

    fn refresh(&mut self) {
        let samples: Vec<_> = self.grid.iter().map(|&p| self.mesh.at(p)).collect();
        self.values = self
            .fill(DVec2::ZERO, |[after, before], weight| (samples[after] + samples[before]) * (0.5 * weight));
    }

    /// The sum of the shuffled terms at the ends of the smallest parts; `value` gives one at the end of a part, from
    /// the points of the grid that are shuffled to there by the parts after and before it, and from its weight.
    fn fill<T>(&self, zero: T, value: impl Fn([usize; 2], f64) -> T) -> Vec<T>
    where
        T: Copy + Add<Output = T> + Mul<f64, Output = T>,
    {
        let mut sums = vec![zero];
        let mut level = 0;
        for k in 1..=self.letters {
            sums = quartered(&sums);
            let (parts, step) = (sums.len(), SYMBOLS.pow((self.letters - k) as u32));
            for family in self.terms.families_at(k) {
                let fixed = self.terms.fixed().map(|weights| weights.list[family.slot(k)]);
                // The digits that are reversed, and those that stay.
                let digits = k - family.kb;
                let low = SYMBOLS.pow(digits as u32) - 1;
                let shift = 2 * (self.letters - digits);
                let shuffled = |i: usize| (i & !low) | (self.order[i & low] as usize >> shift);
                let mut before = shuffled(parts - 1) + 1;
                for (i, sum) in sums.iter_mut().enumerate() {
                    let weight = fixed.unwrap_or_else(|| self.weights[level][i]);
                    let after = shuffled(i);
                    *sum = *sum + value([after * step, before % parts * step], weight);
                    before = after + 1;
                }
                level += 1;
            }
        }
        sums
    }

    /// The mesh as it is now.
    #[must_use]
    pub const fn mesh(&self) -> &Mesh {
        &self.mesh
    }

    /// The deepest digit that is shuffled: 0 where all is plain.
    #[must_use]
    pub const fn letters(&self) -> usize {
        self.letters
    }

    /// Where the point of the curve at `t` goes, which lies at `z`. t counts once around; NaN counts as 0.
    #[must_use]
    pub fn displaced(&self, t: f64, z: DVec2) -> DVec2 {
        let count = self.values.len();
        let place = if t.is_finite() { (t - t.floor()) * count as f64 } else { 0.0 };
        let (from, share) = (place as usize % count, place.fract());
        let to = (from + 1) % count;
        let shuffled = self.values[from] * (1.0 - share) + self.values[to] * share;
        let plain = match self.terms.fixed() {
            Some(weights) => weights.plain,
            None => 1.0 - (self.shares[from] * (1.0 - share) + self.shares[to] * share),
        };
        z + shuffled + if plain == 0.0 { DVec2::ZERO } else { self.mesh.at(z) * plain }
    }
}

/// Values around a ring at ends of parts, and linear between them, at the ends of the quarters of the parts.
fn quartered<T>(values: &[T]) -> Vec<T>
where
    T: Copy + Add<Output = T> + Mul<f64, Output = T>,
{
    let pairs = values.iter().zip(values.iter().cycle().skip(1));
    pairs.flat_map(|(&a, &b)| [0.0, 0.25, 0.5, 0.75].map(|share| a * (1.0 - share) + b * share)).collect()
}

/// All numbers of so many digits, each with its digits in reverse.
fn reversed(digits: usize) -> Vec<u32> {
    let mut list = vec![0_u32];
    for _ in 0..digits {
        // Another digit in front is another one behind.
        let next =
            (0..SYMBOLS as u32).flat_map(|digit| list.iter().map(move |&low| SYMBOLS as u32 * low + digit));
        list = next.collect();
    }
    list
}
