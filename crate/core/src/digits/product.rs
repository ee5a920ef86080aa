//! The product of two digit systems: what their shapes share.

use crate::digits::error::{DigitError, LARGEST_DENOMINATOR, LARGEST_NUMERATOR};
use crate::digits::intersection::{GridIntersection, GridState};
use crate::digits::merging::{Merged, merged};
use crate::digits::reach::gcd;
use crate::digits::shifts::ShiftGraph;
use crate::digits::subsets::SubsetGraph;
use crate::digits::system::DigitSystem;

/// Intersects a shape of a grid with another, moved by `numerators / denominator`.
///
/// # Errors
/// [`DigitError`] where the matrices differ, the shift is no such fraction, or the graph becomes too large.
///
/// ```
/// use frond_core::{AddressCount, DigitSystem, grid_intersection};
///
/// // Cantor's set and itself, moved by a quarter: two copies of a ninth of its size.
/// let cantor = DigitSystem::new([3, 0, 0, 3], vec![[0, 0], [2, 0]])?;
/// let shared = grid_intersection(&cantor, &cantor, [1, 0], 4)?;
/// assert_eq!(shared.states.len(), 2);
/// assert_eq!(shared.attractor().map(|maps| maps.len()), Some(2));
/// assert!((shared.dimension().unwrap_or(0.0) - 2.0_f64.ln() / 9.0_f64.ln()).abs() < 1e-12);
/// assert_eq!(shared.addresses(), AddressCount::Uncountable);
/// # Ok::<(), frond_core::DigitError>(())
/// ```
pub fn grid_intersection(
    first: &DigitSystem,
    second: &DigitSystem,
    numerators: [i64; 2],
    denominator: i64,
) -> Result<GridIntersection, DigitError> {
    if first.matrix() != second.matrix() {
        return Err(DigitError::Matrices);
    }
    let fits = |x: &i64| (-LARGEST_NUMERATOR..=LARGEST_NUMERATOR).contains(x);
    if !(1..=LARGEST_DENOMINATOR).contains(&denominator) || !numerators.iter().all(fits) {
        return Err(DigitError::Shift);
    }
    let shared = numerators.iter().fold(i128::from(denominator), |sum, &x| gcd(sum, i128::from(x).abs()));
    // It divides the denominator, and so is one.
    let shared = i64::try_from(shared).unwrap_or(1);
    let (numerators, denominator) = (numerators.map(|x| x / shared), denominator / shared);
    let graph = ShiftGraph::of(first, second, numerators, denominator)?;
    let of = |kinds: Option<Merged>, sets: &dyn Fn(usize) -> Vec<usize>, is_exact| {
        let Merged { firsts, ways } = kinds?;
        let states = firsts.iter().zip(ways).map(|(&state, ways)| GridState {
            shifts: sets(state).into_iter().map(|shift| graph.shifts[shift]).collect(),
            copies: ways.iter().map(|way| (way.digit, way.to)).collect(),
        });
        Some(GridIntersection {
            states: states.collect(),
            denominator,
            shifts: graph.shifts.len(),
            is_exact,
            maps: (0..first.digits().len()).map(|digit| first.map(digit)).collect(),
        })
    };
    let plain = of(merged(&graph.ways), &|state| vec![state], first.keeps_apart() && second.keeps_apart());
    let subsets = SubsetGraph::of(&graph, first.digits().len());
    let joined = subsets.and_then(|subsets| {
        of(merged(&subsets.ways), &|state| subsets.sets[state].clone(), first.keeps_apart())
    });
    // Which is simpler hangs on the shapes: where one has digits that the other lacks, or where boundaries meet.
    let of_both = [joined, plain].into_iter().flatten();
    let best = of_both.min_by_key(|found| (found.attractor().is_none(), !found.is_exact, found.states.len()));
    best.ok_or(DigitError::TooManyStates)
}
