//! Paths through a locus: found, and judged.

use frond_core::Morph;
use glam::{DVec2, DVec3};
use thiserror::Error;

use crate::field::{Field, Lattice, NEAR_END, Terms, UNSEEN, gap_of};
use crate::grid::{Bounds, GridError, Locus, LocusGrid};
use crate::simplify::simplify;
use crate::space;
use crate::walk::{PathCheck, along, judge};

/// A path from (0, 0, 0) to (1, 1, 0), and how well the morph along it holds together.
#[derive(Clone, Debug, PartialEq)]
pub struct PathPlan {
    /// Its corners (u, v, w), both ends included; at most [`PathPlan::MOST_POINTS`] unless the way is so crooked
    /// that fewer would break it.
    pub points: Vec<DVec3>,
    /// The widest gap met, relative to the diameter of the attractor there, as far as was looked: 0 if it
    /// holds together all the way. Infinite if the path leads through parameters without an attractor.
    pub gap: f64,
    /// Whether no sample along the path was broken.
    pub holds: bool,
    /// The least distance in (u, v, w) from broken samples to the path, but for its first and last eighth of a unit:
    /// the ends often lie on the very boundary. Infinite where none was seen.
    pub clearance: f64,
    /// The parameter where the gap is widest, which is where the path must break; `None` if it holds.
    pub worst: Option<DVec3>,
    /// Whether the two ends lie in different components of what holds together on the samples that were looked at:
    /// then no path within them holds at this resolution, in the square (of `axes` 3, the box) that they cover.
    pub apart: bool,
    /// How far those samples lie apart.
    pub step: f64,
}

impl PathPlan {
    /// The most corners of a path, both ends included.
    pub const MOST_POINTS: usize = 14;

    /// The length in (u, v, w).
    #[must_use]
    pub fn length(&self) -> f64 {
        self.points.windows(2).map(|leg| leg[0].distance(leg[1])).sum()
    }
}

/// Why no path can be planned.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
pub enum PathError {
    /// The locus does not reach (0, 0) and (1, 1).
    #[error("The locus does not hold both (0, 0) and (1, 1). Compute it over a larger rectangle.")]
    Outside,
    /// The locus cannot be sampled.
    #[error(transparent)]
    Grid(#[from] GridError),
}

impl PathError {
    /// A name that stays the same over versions, for programs.
    #[must_use]
    pub const fn code(&self) -> &'static str {
        match self {
            Self::Outside => "path-outside",
            Self::Grid(error) => error.code(),
        }
    }
}

/// Which parameters a path may take.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Axes {
    /// (u, v): stretch and turn go together, as in Burch & Hart's plane.
    #[default]
    Two,
    /// (u, v, w): the stretch may be ahead of the turn, or behind it.
    Three,
}

/// How to plan a path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathOptions {
    /// Relative to the diameter of the attractor: gaps up to it count as none.
    pub epsilon: f64,
    /// Samples along a side of the first locus to look at; finer ones follow where it is too coarse.
    pub size: usize,
    /// The parameters to take. With three, a path in the plane w = 0 that holds is preferred.
    pub axes: Axes,
}

impl Default for PathOptions {
    fn default() -> Self {
        Self { epsilon: 1.0 / 600.0, size: 97, axes: Axes::Two }
    }
}

/// Plans a path through a locus that is known already: of all ways the widest gap is least; of these, those with much
/// room to what is broken are taken, and of these a short one with few corners.
///
/// The verdict is that of the samples next to the path; [`check_path`](crate::check_path) looks again in between. Gaps
/// up to `epsilon` count as none.
///
/// # Errors
/// [`PathError::Outside`] if the locus does not reach both ends.
pub fn plan_path(locus: &Locus, epsilon: f64) -> Result<PathPlan, PathError> {
    Ok(plan_in(&field_of(locus, epsilon)?))
}

/// The ends of every path.
pub(crate) const ENDS: [DVec3; 2] = [DVec3::ZERO, DVec3::new(1.0, 1.0, 0.0)];

pub(crate) fn field_of(locus: &Locus, epsilon: f64) -> Result<Field, PathError> {
    let Bounds { u0, v0, u1, v1 } = locus.grid().bounds();
    let (width, height) = (locus.grid().width(), locus.grid().height());
    let lattice = Lattice {
        size: [width, height, 1],
        low: DVec2::new(u0, v0).extend(0.0),
        high: DVec2::new(u1, v1).extend(0.0),
    };
    let gap = (0..width * height).map(|i| gap_of(locus.sample(i % width, i / width), epsilon)).collect();
    let [from, to] = ENDS.map(|end| lattice.cell(lattice.fraction(end)));
    let (Some(from), Some(to)) = (from, to) else { return Err(PathError::Outside) };
    Ok(Field::new(lattice, gap, [from, to]))
}

/// Where every way breaks, gaps this much wider than the least count as no wider; more only where the way has too many
/// corners otherwise.
const AS_WIDE: [f64; 7] = [1.02, 1.05, 1.1, 1.2, 1.5, 2.0, f64::INFINITY];
/// The part of the most room that a way must keep, so that it may be straight.
const ROOMY: f64 = 0.6;

pub(crate) fn plan_in(field: &Field) -> PathPlan {
    let widest = field.widest();
    // Where it must break there is no room at the break.
    let room = if widest > 0.0 { 0.0 } else { ROOMY * field.roomiest(widest).max(0.0) };
    let mut kept = Vec::new();
    for tolerance in AS_WIDE {
        // The last tolerates all.
        let terms = Terms { widest: (tolerance * widest).min(UNSEEN), room };
        kept = simplify(field, &field.cheapest(terms), terms, PathPlan::MOST_POINTS);
        // A way that holds does so however many corners it takes.
        if widest == 0.0 || kept.len() <= PathPlan::MOST_POINTS {
            break;
        }
    }
    let mut points: Vec<DVec3> =
        kept.iter().map(|&cell| field.lattice.parameter(field.lattice.place(cell))).collect();
    // The cells next to the ends stand for the ends themselves.
    if points.len() < 2 {
        points = ENDS.to_vec();
    }
    let last = points.len() - 1;
    (points[0], points[last]) = (ENDS[0], ENDS[1]);
    let steps = 4 * points.len() * field.side() as usize;
    let met = (0..=steps).map(|k| along(&points, k as f64 / steps as f64));
    let wide = |at: &DVec3| field.gap_at(*at);
    let worst = if widest > 0.0 { met.max_by(|a, b| wide(a).total_cmp(&wide(b))) } else { None };
    PathPlan {
        clearance: clearance(field, &points),
        points,
        gap: if widest < 1.0 { widest } else { f64::INFINITY },
        holds: widest <= 0.0,
        worst,
        apart: widest > 0.0,
        step: field.step(),
    }
}

/// The clearance of a polygon: see [`PathPlan::clearance`].
fn clearance(field: &Field, points: &[DVec3]) -> f64 {
    let steps = 4 * points.len() * field.side() as usize;
    let met = (0..=steps).map(|k| along(points, k as f64 / steps as f64));
    let far = met.filter(|at| ENDS.iter().all(|end| end.distance(*at) >= NEAR_END));
    let cells = far.filter_map(|at| field.lattice.cell(field.lattice.fraction(at)));
    cells.map(|cell| field.clearance(cell)).fold(f64::INFINITY, f64::min)
}

/// Plans a path from the first shape of a morph to the last and checks it between the samples of the locus,
/// on finer loci until it holds or is found not to.
///
/// # Errors
/// [`PathError::Grid`] for a size out of range.
pub fn find_path(morph: &Morph, options: &PathOptions) -> Result<PathPlan, PathError> {
    match options.axes {
        Axes::Two => find_in_plane(morph, options, &[1, 2, 4]),
        Axes::Three => {
            let plane = find_in_plane(morph, options, &[1])?;
            if plane.holds {
                return Ok(plane);
            }
            let space = space::find(morph, options);
            Ok(if space.gap < plane.gap { space } else { plane })
        }
    }
}

fn find_in_plane(morph: &Morph, options: &PathOptions, refinements: &[usize]) -> Result<PathPlan, PathError> {
    let PathOptions { epsilon, size, .. } = *options;
    let mut best: Option<PathPlan> = None;
    // A side of 3 k + 1 samples holds both ends.
    let thirds = size.saturating_sub(1).div_ceil(3).max(1);
    for &refinement in refinements {
        let side = (3 * thirds).saturating_mul(refinement).saturating_add(1);
        let grid = match LocusGrid::new(Bounds::default(), side, side) {
            Ok(grid) => grid,
            Err(error) if best.is_none() => return Err(error.into()),
            Err(_) => break,
        };
        let mut field = field_of(&grid.locus(morph, epsilon), epsilon)?;
        let tried = improve(morph, &mut field, epsilon, CHECKS.max(8 * side), REPAIRS);
        let done = tried.plan.holds || tried.final_word;
        let (apart, step) = (tried.plan.apart, tried.plan.step);
        if best.as_ref().is_none_or(|best| tried.plan.gap < best.gap) {
            best = Some(tried.plan);
        }
        // What the finest samples say of the components.
        best = best.map(|best| PathPlan { apart, step, ..best });
        if done {
            break;
        }
    }
    best.ok_or(PathError::Outside)
}

/// What came of planning in one field.
pub(crate) struct Tried {
    /// The best plan, judged between the samples.
    pub plan: PathPlan,
    /// Whether the samples themselves have no better way: then a finer locus seldom has.
    pub final_word: bool,
    /// The cells that were found broken.
    pub marked: Vec<usize>,
}

/// Plans, judges between the samples, keeps off where it is broken there, and plans again.
pub(crate) fn improve(
    morph: &Morph,
    field: &mut Field,
    epsilon: f64,
    checks: usize,
    repairs: usize,
) -> Tried {
    let mut best: Option<PathPlan> = None;
    let mut least = None;
    let mut marked = Vec::new();
    let mut final_word = false;
    for _ in 0..repairs.max(1) {
        let planned = plan_in(field);
        let (at_first, apart) = *least.get_or_insert((planned.gap, planned.apart));
        let mut broken = Vec::new();
        let checked = judge(morph, &planned.points, epsilon, checks, |at| broken.push(at));
        let gap = checked.gap;
        final_word = checked.holds || gap <= 1.2 * at_first;
        let too_wide = planned.gap > at_first;
        if best.as_ref().is_none_or(|best| gap < best.gap) {
            let PathCheck { holds, worst, .. } = checked;
            best = Some(PathPlan { gap, holds, worst, apart, ..planned });
        }
        if checked.holds {
            best = best.map(|best| straightened(morph, field, best, epsilon));
        }
        if final_word || too_wide {
            break;
        }
        // Broken between samples that hold: keep off, and look for another way.
        let mut cells: Vec<usize> = broken.iter().filter_map(|&at| field.culprit(at)).collect();
        cells.sort_unstable();
        cells.dedup();
        field.mark(&cells, gap);
        marked.append(&mut cells);
    }
    // The loop ran at least once.
    let plan = best.unwrap_or_else(|| plan_in(field));
    Tried { plan, final_word, marked }
}

/// A plan that holds, without the corners that it can do without: the legs instead of them are decided themselves, which
/// tells more than the samples around them.
fn straightened(morph: &Morph, field: &Field, mut plan: PathPlan, epsilon: f64) -> PathPlan {
    let mut k = 1;
    while k + 1 < plan.points.len() {
        let leg = [plan.points[k - 1], plan.points[k + 1]];
        let samples = (LEG_CHECKS * leg[0].distance(leg[1]) / field.step()).ceil().min(1e4) as usize;
        let shortcut = clearance(field, &leg) >= ROOMY * plan.clearance
            && judge(morph, &leg, epsilon, samples, |_| ()).holds;
        if shortcut {
            plan.points.remove(k);
        } else {
            k += 1;
        }
    }
    plan.clearance = clearance(field, &plan.points);
    plan
}

/// Parameters decided on a leg for each sample that it passes.
const LEG_CHECKS: f64 = 16.0;
/// Parameters decided along a plan, at least.
pub(crate) const CHECKS: usize = 2048;
/// How often a plan is mended before a finer locus is taken.
pub(crate) const REPAIRS: usize = 8;

#[cfg(test)]
mod tests {
    use frond_core::{Affine2, MorphOptions};

    use super::*;
    use crate::decide::{Sample, State};
    use crate::walk::check_path;

    /// A locus drawn by hand: `#` holds, a digit is a gap of so many tenths, `x` has no attractor. Row 0 of
    /// the picture is on top.
    fn drawn(rows: &[&str]) -> Locus {
        let bounds = Bounds { u0: 0.0, v0: 0.0, u1: 1.0, v1: 1.0 };
        let grid = LocusGrid::new(bounds, rows[0].len(), rows.len()).unwrap();
        let samples = rows.iter().rev().flat_map(|row| row.bytes()).map(|cell| match cell {
            b'#' => Sample { state: State::Touching, gap: 0.0 },
            b'x' => Sample { state: State::NoAttractor, gap: f32::NAN },
            digit => Sample { state: State::Disconnected, gap: f32::from(digit - b'0') / 10.0 },
        });
        let samples: Vec<Sample> = samples.collect();
        let state = samples.iter().map(|s| s.state as u8).collect();
        Locus::from_parts(grid, state, samples.iter().map(|s| s.gap).collect()).unwrap()
    }

    /// The widest gap of the samples that the path passes.
    fn met(locus: &Locus, points: &[DVec3]) -> f32 {
        let grid = locus.grid();
        let cell = |p: DVec3| {
            let (x, y) = (p.x * (grid.width() - 1) as f64, p.y * (grid.height() - 1) as f64);
            locus.sample(x.round() as usize, y.round() as usize).gap
        };
        (0..=2000)
            .map(|k| cell(along(points, f64::from(k) / 2000.0)))
            .fold(0.0, |a, b| if b > a || b.is_nan() { b } else { a })
    }

    #[test]
    fn it_goes_round_what_is_broken() {
        let locus = drawn(&[
            "###########",
            "###########",
            "##555555###",
            "##555555###",
            "##555555###",
            "##555555###",
            "##555555###",
            "##555555###",
            "##555555###",
            "###########",
            "###########",
        ]);
        let plan = plan_path(&locus, 0.0).unwrap();
        assert!(plan.holds && plan.gap == 0.0, "{plan:?}");
        assert_eq!((plan.points[0], plan.points[plan.points.len() - 1]), (ENDS[0], ENDS[1]));
        assert!(plan.points.len() <= 6, "{plan:?}");
        assert_eq!(met(&locus, &plan.points), 0.0);
    }

    #[test]
    fn where_it_must_break_the_gap_is_least_and_walls_are_last() {
        let locus = drawn(&["##9####", "##9####", "##3####", "##1####", "##2####", "##8####", "##x####"]);
        let plan = plan_path(&locus, 0.0).unwrap();
        assert!((plan.gap - 0.1).abs() < 1e-6 && !plan.holds, "{plan:?}");
        assert!((met(&locus, &plan.points) - 0.1).abs() < 1e-6);
        assert!(plan_path(&locus, 0.1001).unwrap().holds);
        let walled = plan_path(&drawn(&["##x##", "##x##", "##x##"]), 0.0).unwrap();
        assert!(walled.gap.is_infinite() && !walled.holds);
    }

    #[test]
    fn it_does_not_squeeze_between_two_broken_samples() {
        let locus = drawn(&["5#", "#5"]);
        assert!(plan_path(&locus, 0.0).unwrap().gap > 0.4);
    }

    #[test]
    fn it_keeps_away_from_the_edge_where_there_is_room() {
        let mut rows = vec!["#".repeat(40); 12];
        rows.extend(vec!["5".repeat(38) + "##"; 1]);
        rows.extend(vec!["#".repeat(40); 12]);
        // The straight way along the barrier's side would touch it.
        let rows: Vec<&str> = rows.iter().map(String::as_str).collect();
        let locus = drawn(&rows);
        let plan = plan_path(&locus, 0.0).unwrap();
        assert!(plan.holds && met(&locus, &plan.points) == 0.0, "{plan:?}");
    }

    #[test]
    fn a_locus_that_misses_an_end_is_refused() {
        let bounds = Bounds { u0: 0.3, ..Bounds::default() };
        let grid = LocusGrid::new(bounds, 3, 3).unwrap();
        let locus = Locus::from_parts(grid, vec![0; 9], vec![0.0; 9]).unwrap();
        assert_eq!(plan_path(&locus, 0.0), Err(PathError::Outside));
        let dot = LocusGrid::new(Bounds { u0: 0.0, v0: 0.0, u1: 0.0, v1: 0.0 }, 3, 3).unwrap();
        let locus = Locus::from_parts(dot, vec![0; 9], vec![0.0; 9]).unwrap();
        assert_eq!(plan_path(&locus, 0.0), Err(PathError::Outside));
        let single = LocusGrid::new(Bounds { u0: 0.0, v0: 0.0, u1: 1.0, v1: 1.0 }, 1, 1).unwrap();
        let locus = Locus::from_parts(single, vec![0], vec![0.0]).unwrap();
        assert_eq!(plan_path(&locus, 0.0).unwrap().points, ENDS);
    }

    #[test]
    fn the_terdragon_reaches_the_gasket_in_one_piece() {
        let row = Affine2::from_row;
        // {l z, -i z / sqrt 3 + l, l z + conj l}, l = 1/2 + i / (2 sqrt 3).
        let (h, r) = (1.0 / 12.0_f64.sqrt(), 1.0 / 3.0_f64.sqrt());
        let terdragon = [
            row([0.5, -h, h, 0.5, 0.0, 0.0]),
            row([0.0, r, -r, 0.0, 0.5, h]),
            row([0.5, -h, h, 0.5, 0.5, -h]),
        ];
        let corners = [[0.0, 0.0], [1.0, 0.0], [0.5, 0.75_f64.sqrt()]].map(DVec2::from_array);
        let gasket = corners.map(|c| Affine2::similitude(0.5, 0.0, c * 0.5));
        let morph = Morph::new(&terdragon, &gasket, &MorphOptions::default()).unwrap();
        let plan = find_path(&morph, &PathOptions { epsilon: 1e-4, ..Default::default() }).unwrap();
        assert!(plan.holds, "{plan:?}");
    }

    #[test]
    fn the_dragon_reaches_the_gasket_in_one_piece() {
        let row = Affine2::from_row;
        let (a, b) = (row([0.5, -0.5, 0.5, 0.5, 0.0, 0.0]), row([-0.5, -0.5, 0.5, -0.5, 1.0, 0.0]));
        let corners = [[0.0, 0.0], [1.0, 0.0], [0.5, 0.75_f64.sqrt()]].map(DVec2::from_array);
        let gasket = corners.map(|c| Affine2::similitude(0.5, 0.0, c * 0.5));
        let morph = Morph::new(&[a, b * a, b * b], &gasket, &MorphOptions::default()).unwrap();
        let options = PathOptions { epsilon: 1e-3, size: 49, ..Default::default() };
        let plan = find_path(&morph, &options).unwrap();
        assert!(plan.holds && plan.gap == 0.0 && plan.points.len() <= PathPlan::MOST_POINTS, "{plan:?}");
        assert!(check_path(&morph, &plan.points, 1e-3, 2003).holds);
        let straight = check_path(&morph, &ENDS, 1e-3, 400);
        assert!(!straight.holds && straight.gap > 0.01 && !straight.breaks.is_empty(), "{straight:?}");
        let (start, end) = straight.breaks[0];
        assert!(0.0 < start && start < end && end < 1.0);
    }
}
