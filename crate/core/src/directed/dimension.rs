//! The dimension of a graph-directed system.

use crate::directed::measure::dimension_of_class;
use crate::directed::reach;
use crate::directed::system::DirectedIfs;

/// The similarity dimension of a state: the largest `s` at which the matrix of the sums of `r^s` over the maps from
/// state to state has the spectral radius 1, over the classes of states that it is made of (Mauldin & Williams 1988).
///
/// It is the Hausdorff dimension where copies do not overlap, and never below it. `None` where some map that the state
/// is made of is not a similitude, or there is no such state.
///
/// ```
/// use frond_core::{Affine2, DirectedIfs, DirectedMap, directed_dimension};
/// # use glam::DVec2;
/// // K = K/2 u (L/2 + 1/2), L = K/2: as many pieces as Fibonacci's numbers.
/// let half = |from, e| DirectedMap { from, map: Affine2::similitude(0.5, 0.0, DVec2::new(e, 0.0)) };
/// let system = DirectedIfs::new(vec![vec![half(0, 0.0), half(1, 0.5)], vec![half(0, 0.0)]])?;
/// let golden = (1.0 + 5.0_f64.sqrt()) / 2.0;
/// assert!((directed_dimension(&system, 0).unwrap_or(0.0) - golden.log2()).abs() < 1e-12);
/// # Ok::<(), frond_core::DirectedError>(())
/// ```
#[must_use]
pub fn directed_dimension(system: &DirectedIfs, state: usize) -> Option<f64> {
    let states = system.states();
    if state >= states.len() {
        return None;
    }
    let made_of = reach::reached(states, state);
    let used = |state: &usize| made_of[*state];
    let alike =
        (0..states.len()).filter(used).flat_map(|i| &states[i]).all(|part| part.map.is_similitude(1e-9));
    let classes = reach::classes(states);
    let each = (0..states.len()).filter(|&i| made_of[i] && classes[i] == i);
    alike.then(|| each.map(|label| dimension_of_class(states, &classes, label)).fold(0.0, f64::max))
}
