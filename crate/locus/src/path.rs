//! Paths through a locus: found, and judged.

use frond_core::Morph;
use glam::DVec2;
use thiserror::Error;

use crate::decide::{Scratch, State, decide};
use crate::field::Field;
use crate::grid::{Bounds, GridError, Locus, LocusGrid};
use crate::simplify::simplify;

/// A path from (0, 0) to (1, 1), and how well the morph along it holds together.
#[derive(Clone, Debug, PartialEq)]
pub struct PathPlan {
    /// Its corners (u, v), both ends included; at most [`PathPlan::MOST_POINTS`] unless the way is so crooked
    /// that fewer would break it.
    pub points: Vec<DVec2>,
    /// The widest gap met, relative to the diameter of the attractor there, as far as was looked: 0 if it
    /// holds together all the way. Infinite if the path leads through parameters without an attractor.
    pub gap: f64,
    /// Whether no sample along the path was broken.
    pub holds: bool,
}

impl PathPlan {
    /// The most corners of a path, both ends included.
    pub const MOST_POINTS: usize = 14;
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

/// How to plan a path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathOptions {
    /// Relative to the diameter of the attractor: gaps up to it count as none.
    pub epsilon: f64,
    /// Samples along a side of the first locus to look at; finer ones follow where it is too coarse.
    pub size: usize,
}

impl Default for PathOptions {
    fn default() -> Self {
        Self { epsilon: 1.0 / 600.0, size: 97 }
    }
}

/// Plans a path through a locus that is known already: of all ways the widest gap is least, then those that
/// are short and keep away from broken parameters are taken.
///
/// The verdict is that of the samples next to the path; [`check_path`] looks again in between. Gaps up to
/// `epsilon` count as none.
///
/// # Errors
/// [`PathError::Outside`] if the locus does not reach both ends.
pub fn plan_path(locus: &Locus, epsilon: f64) -> Result<PathPlan, PathError> {
    plan_in(locus.grid(), &Field::of(locus, epsilon))
}

fn plan_in(grid: &LocusGrid, field: &Field) -> Result<PathPlan, PathError> {
    let ends = [DVec2::ZERO, DVec2::ONE];
    let Some([from, to]) = cells(grid, field, ends) else { return Err(PathError::Outside) };
    let widest = field.widest(from, to);
    let way = field.cheapest(from, to, widest);
    let kept = simplify(field, &way, widest, PathPlan::MOST_POINTS);
    let mut points: Vec<DVec2> = kept
        .iter()
        .map(|&cell| {
            let (x, y) = field.place(cell);
            DVec2::new(grid.u(x as usize), grid.v(y as usize))
        })
        .collect();
    // The cells next to the ends stand for the ends themselves.
    points[0] = ends[0];
    if points.len() == 1 {
        points.push(ends[1]);
    }
    let last = points.len() - 1;
    points[last] = ends[1];
    let gap = if widest < 1.0 { widest } else { f64::INFINITY };
    Ok(PathPlan { points, gap, holds: widest <= 0.0 })
}

/// The cells of two points, unless one lies outside.
fn cells(grid: &LocusGrid, field: &Field, points: [DVec2; 2]) -> Option<[usize; 2]> {
    let Bounds { u0, v0, u1, v1 } = grid.bounds();
    let along = |from: f64, to: f64, at: f64, count: usize| {
        let t = (at - from) / (to - from);
        if to == from || !(-1e-9..=1.0 + 1e-9).contains(&t) { f64::NAN } else { t * (count - 1) as f64 }
    };
    let cell = |p: DVec2| field.cell(along(u0, u1, p.x, grid.width()), along(v0, v1, p.y, grid.height()));
    Some([cell(points[0])?, cell(points[1])?])
}

/// Plans a path from the first shape of a morph to the last and checks it between the samples of the locus,
/// on finer loci until it holds or is found not to.
///
/// # Errors
/// [`PathError::Grid`] for a size out of range.
pub fn find_path(morph: &Morph, options: &PathOptions) -> Result<PathPlan, PathError> {
    let PathOptions { epsilon, size } = *options;
    let mut best: Option<PathPlan> = None;
    // A side of 3 k + 1 samples holds both ends.
    let thirds = size.saturating_sub(1).div_ceil(3).max(1);
    for refinement in [1, 2, 4] {
        let side = (3 * thirds).saturating_mul(refinement).saturating_add(1);
        let grid = match LocusGrid::new(Bounds::default(), side, side) {
            Ok(grid) => grid,
            Err(error) if best.is_none() => return Err(error.into()),
            Err(_) => break,
        };
        let mut field = Field::of(&grid.locus(morph, epsilon), epsilon);
        let mut at_first = None;
        for _ in 0..REPAIRS {
            let planned = plan_in(&grid, &field)?;
            let least = *at_first.get_or_insert(planned.gap);
            let mut broken = Vec::new();
            let checked = judge(morph, &planned.points, epsilon, CHECKS.max(8 * side), |at| broken.push(at));
            let (gap, holds) = (checked.gap, checked.holds);
            if best.as_ref().is_none_or(|best| gap < best.gap) {
                best = Some(PathPlan { gap, holds, points: planned.points });
            }
            // Where the samples themselves have no better way, a finer locus seldom has.
            if holds || gap <= 1.2 * least {
                return best.ok_or(PathError::Outside);
            }
            if planned.gap > least {
                break;
            }
            // Broken between samples that hold: keep off, and look for another way.
            let cells: Vec<usize> =
                broken.iter().filter_map(|&p| cells(&grid, &field, [p; 2])).map(|[cell, _]| cell).collect();
            field.mark(cells.into_iter(), gap);
        }
    }
    best.ok_or(PathError::Outside)
}

/// Parameters decided along a plan, at least.
const CHECKS: usize = 2048;
/// How often a plan is mended before a finer locus is taken.
const REPAIRS: usize = 8;

/// What [`check_path`] found.
#[derive(Clone, Debug, PartialEq)]
pub struct PathCheck {
    /// The widest relative gap met; infinite where there is no attractor, 0 where all holds.
    pub gap: f64,
    /// Whether no sample was broken: none apart by more than epsilon, none undecided, none without attractor.
    pub holds: bool,
    /// The broken stretches, as fractions of the length of the path in (u, v).
    pub breaks: Vec<(f64, f64)>,
}

/// Decides `samples` parameters spread evenly along a path, both ends included, and reports where it breaks.
/// A path of no points holds.
#[must_use]
pub fn check_path(morph: &Morph, points: &[DVec2], epsilon: f64, samples: usize) -> PathCheck {
    judge(morph, points, epsilon, samples, |_| ())
}

/// [`check_path`], which also tells each broken sample.
fn judge(
    morph: &Morph,
    points: &[DVec2],
    epsilon: f64,
    samples: usize,
    mut tell: impl FnMut(DVec2),
) -> PathCheck {
    let mut check = PathCheck { gap: 0.0, holds: true, breaks: Vec::new() };
    if points.is_empty() {
        return check;
    }
    let samples = samples.max(2);
    let half = 0.5 / (samples - 1) as f64;
    let mut scratch = Scratch::default();
    let mut maps = Vec::new();
    let mut was_broken = false;
    for k in 0..samples {
        let t = k as f64 / (samples - 1) as f64;
        let at = along(points, t);
        morph.fill(at.x, at.y, &mut maps);
        let sample = decide(&maps, epsilon, LocusGrid::budget(maps.len()), &mut scratch);
        let gap = if sample.gap.is_nan() { f64::INFINITY } else { f64::from(sample.gap) };
        let broken = match sample.state {
            State::Connected | State::Touching => false,
            State::Disconnected => gap > epsilon,
            State::Undecided | State::NoAttractor => true,
        };
        if broken {
            tell(at);
            check.holds = false;
            check.gap = check.gap.max(gap);
            match check.breaks.last_mut() {
                Some(last) if was_broken => last.1 = (t + half).min(1.0),
                _ => check.breaks.push(((t - half).max(0.0), (t + half).min(1.0))),
            }
        }
        was_broken = broken;
    }
    check
}

/// The point at the fraction `t` of the length of a polygon.
///
/// # Panics
/// If there are no points.
#[must_use]
pub fn along(points: &[DVec2], t: f64) -> DVec2 {
    let length: f64 = points.windows(2).map(|leg| leg[0].distance(leg[1])).sum();
    let mut left = t.clamp(0.0, 1.0) * length;
    for leg in points.windows(2) {
        let step = leg[0].distance(leg[1]);
        if left <= step && step > 0.0 {
            // Exact at both ends.
            return if left == step { leg[1] } else { leg[0].lerp(leg[1], left / step) };
        }
        left -= step;
    }
    points[points.len() - 1]
}

#[cfg(test)]
mod tests {
    use frond_core::{Affine2, MorphOptions};

    use super::*;
    use crate::decide::Sample;

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
    fn met(locus: &Locus, points: &[DVec2]) -> f32 {
        let grid = locus.grid();
        let cell = |p: DVec2| {
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
        assert_eq!((plan.points[0], plan.points[plan.points.len() - 1]), (DVec2::ZERO, DVec2::ONE));
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
        assert_eq!(plan_path(&locus, 0.0).unwrap().points, [DVec2::ZERO, DVec2::ONE]);
    }

    #[test]
    fn lengths_along_a_polygon() {
        let points = [DVec2::ZERO, DVec2::X, DVec2::X, DVec2::new(1.0, 3.0)];
        assert_eq!(along(&points, 0.0), DVec2::ZERO);
        assert_eq!(along(&points, 0.125), DVec2::new(0.5, 0.0));
        assert_eq!(along(&points, 0.25), DVec2::X);
        assert_eq!(along(&points, 1.0), DVec2::new(1.0, 3.0));
        assert_eq!(along(&points[..1], 0.5), DVec2::ZERO);
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
        let plan = find_path(&morph, &PathOptions { epsilon: 1e-4, size: 97 }).unwrap();
        assert!(plan.holds, "{plan:?}");
    }

    #[test]
    fn the_dragon_reaches_the_gasket_in_one_piece() {
        let row = Affine2::from_row;
        let (a, b) = (row([0.5, -0.5, 0.5, 0.5, 0.0, 0.0]), row([-0.5, -0.5, 0.5, -0.5, 1.0, 0.0]));
        let corners = [[0.0, 0.0], [1.0, 0.0], [0.5, 0.75_f64.sqrt()]].map(DVec2::from_array);
        let gasket = corners.map(|c| Affine2::similitude(0.5, 0.0, c * 0.5));
        let morph = Morph::new(&[a, b * a, b * b], &gasket, &MorphOptions::default()).unwrap();
        let options = PathOptions { epsilon: 1e-3, size: 49 };
        let plan = find_path(&morph, &options).unwrap();
        assert!(plan.holds && plan.gap == 0.0 && plan.points.len() <= PathPlan::MOST_POINTS, "{plan:?}");
        assert!(check_path(&morph, &plan.points, 1e-3, 2003).holds);
        let straight = check_path(&morph, &[DVec2::ZERO, DVec2::ONE], 1e-3, 400);
        assert!(!straight.holds && straight.gap > 0.01 && !straight.breaks.is_empty(), "{straight:?}");
        let (start, end) = straight.breaks[0];
        assert!(0.0 < start && start < end && end < 1.0);
    }
}
