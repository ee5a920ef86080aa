//! The locus of a morph between graph-directed systems.

use std::ops::Range;

use frond_core::{DirectedError, DirectedIfs, DirectedMorph, IfsError};

use crate::directed::connectedness::{Look, deeper};
use crate::directed::extent::Extent;
use crate::directed::shared_points::{Shared, closed};
use crate::grid::{LocusGrid, Tile};
use crate::magnification::Magnification;
use crate::verdict::{Sample, State, Verdict};

/// Pairs of pieces that are looked at for each state of a sample; of more than ten maps so many for each map.
const BUDGET: usize = 2_000;
const BUDGET_PER_MAP: usize = 200;

/// Points that pieces share exactly are looked for where u and v are so many parts of 1, and few of other samples have
/// any: the search takes ten times as long as all else.
const PROOFS_PER_UNIT: f64 = 4.0;

/// Decides every `stride`th sample of the rows of a range that are a multiple of it: where, over (u, v), the shape of a
/// morph between graph-directed systems, its first state, is in one piece. `epsilon` is relative to the diameter of
/// each state.
///
/// It is [`directed_connectedness`] of that state alone, which looks no further than that takes, with a smaller budget;
/// what is `Connected` may be told as `Touching`. Burch & Hart (1997, section 5) draw such a map for systems of one
/// state, and ask for morphs of several (section 7.1).
///
/// [`directed_connectedness`]: crate::directed_connectedness
#[must_use]
pub fn directed_tile(
    grid: &LocusGrid,
    morph: &DirectedMorph,
    epsilon: f64,
    rows: Range<usize>,
    stride: usize,
) -> Tile {
    let stride = stride.max(1);
    let (mut state, mut gap) = (Vec::new(), Vec::new());
    for row in (rows.start..rows.end.min(grid.height())).filter(|row| row.is_multiple_of(stride)) {
        for column in (0..grid.width()).step_by(stride) {
            let found = sample(morph, [grid.u(column), grid.v(row)], epsilon.max(0.0));
            state.push(found.state as u8);
            gap.push(found.gap);
        }
    }
    Tile { state, gap }
}

fn sample(morph: &DirectedMorph, [u, v]: [f64; 2], epsilon: f64) -> Sample {
    let short = |x: f64| (PROOFS_PER_UNIT * x).fract() == 0.0;
    let states = morph.at(u, v);
    let states = match Magnification::of_states(&states) {
        Some(magnification) => magnification.magnify_states(&states),
        None => states,
    };
    match DirectedIfs::new(states) {
        Ok(system) => of_shape(&system, epsilon, short(u) && short(v)),
        Err(DirectedError::Unproved | DirectedError::Ifs(IfsError::Unproved)) => {
            Sample { state: State::Undecided, gap: f32::NAN }
        }
        Err(_) => Sample { state: State::NoAttractor, gap: f32::NAN },
    }
}

/// What is known of the first state; points that pieces share exactly are looked for where `proofs` says so.
fn of_shape(system: &DirectedIfs, epsilon: f64, proofs: bool) -> Sample {
    let extents = Extent::of(system);
    let size = extents[0].diameter.max(f64::MIN_POSITIVE);
    let apart = |gap: f64| Sample { state: State::Disconnected, gap: (gap / size) as f32 };
    let touching = Sample { state: State::Touching, gap: 0.0 };
    let budget = |state: usize| BUDGET.max(BUDGET_PER_MAP * system.states()[state].len());
    let look = |state: usize| Look::at(system, &extents, state, epsilon, budget(state), false);
    let first = look(0);
    if first.widest.lower > 0.0 {
        return apart(first.widest.upper);
    }
    if proofs {
        let diameters: Vec<f64> = extents.iter().map(|extent| extent.diameter).collect();
        if Shared::of(system, &diameters).is_some_and(|(given, _)| closed(system, &given.joined)[0]) {
            return Sample { state: State::Connected, gap: 0.0 };
        }
    }
    let looks: Vec<Look> = (1..system.len()).map(look).collect();
    let all = || std::iter::once(&first).chain(&looks);
    let held = closed(system, &all().map(|look| look.holds).collect::<Vec<_>>());
    if held[0] {
        return touching;
    }
    if first.holds {
        let gaps: Vec<f64> = all().map(|look| look.widest.lower).collect();
        match deeper(system, &extents, 0, &held, &gaps, epsilon, budget(0)).0 {
            Some((Verdict::Disconnected, edge)) => return apart(edge.upper),
            Some(_) => return touching,
            None => {}
        }
    }
    Sample { state: State::Undecided, gap: (first.widest.upper / size).min(1.0) as f32 }
}
