//! Paths through a locus that is known.

use glam::{DVec2, DVec3};
use thiserror::Error;

use crate::grid::{Bounds, GridError, Locus};
use crate::path::field::{END_RADIUS, Field, GAP_UNSEEN, Lattice, Terms, gap_of};
use crate::path::simplify::simplify;
use frond_core::along;

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
#[non_exhaustive]
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
const GAP_TOLERANCES: [f64; 7] = [1.02, 1.05, 1.1, 1.2, 1.5, 2.0, f64::INFINITY];
/// The part of the most room that a way must keep, so that it may be straight.
pub(crate) const ROOM_SHARE: f64 = 0.6;

pub(crate) fn plan_in(field: &Field) -> PathPlan {
    let widest = field.widest();
    // Where it must break there is no room at the break.
    let room = if widest > 0.0 { 0.0 } else { ROOM_SHARE * field.roomiest(widest).max(0.0) };
    let mut kept = Vec::new();
    for tolerance in GAP_TOLERANCES {
        // The last tolerates all.
        let terms = Terms { widest: (tolerance * widest).min(GAP_UNSEEN), room };
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
pub(crate) fn clearance(field: &Field, points: &[DVec3]) -> f64 {
    let steps = 4 * points.len() * field.side() as usize;
    let met = (0..=steps).map(|k| along(points, k as f64 / steps as f64));
    let far = met.filter(|at| ENDS.iter().all(|end| end.distance(*at) >= END_RADIUS));
    let cells = far.filter_map(|at| field.lattice.cell(field.lattice.fraction(at)));
    cells.map(|cell| field.clearance(cell)).fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::LocusGrid;
    use crate::verdict::{Sample, State};

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
        assert!((plan.gap - 0.1).abs() < 1e-6 && !plan.holds && plan.apart, "{plan:?}");
        // Column 2 of 0 to 6 and row 3, where the gap is least.
        let worst = plan.worst.unwrap();
        assert!((worst.x - 2.0 / 6.0).abs() < 0.1 && (worst.y - 0.5).abs() < 0.1, "{worst}");
        assert_eq!(plan.clearance, 0.0);
        assert!((met(&locus, &plan.points) - 0.1).abs() < 1e-6);
        assert!(plan_path(&locus, 0.1001).unwrap().holds);
        let walled = plan_path(&drawn(&["##x##", "##x##", "##x##"]), 0.0).unwrap();
        assert!(walled.gap.is_infinite() && !walled.holds);
    }

    #[test]
    fn the_roomier_way_is_taken_though_it_is_longer() {
        // A wall from side to side with two doors: one three samples wide on the straight way, and one of ten.
        let mut rows = vec!["#".repeat(41); 41];
        rows[10] =
            (0..41).map(|x| if (29..32).contains(&x) || (2..12).contains(&x) { '#' } else { '5' }).collect();
        let rows: Vec<&str> = rows.iter().map(String::as_str).collect();
        let plan = plan_path(&drawn(&rows), 0.0).unwrap();
        let met = (0..=1000).map(|k| along(&plan.points, f64::from(k) / 1000.0));
        let at_wall: Vec<f64> = met.filter(|p| (p.y - 0.75).abs() < 0.02).map(|p| p.x).collect();
        assert!(at_wall.iter().all(|x| (3.0 / 40.0..10.0 / 40.0).contains(x)), "{plan:?}");
        assert!(plan.holds && !plan.apart && plan.worst.is_none());
        // The middle of the door is five and a half samples from the wall; straightness may cost a part of that.
        assert!(plan.clearance >= 2.0 / 40.0 && plan.clearance <= 6.0 / 40.0, "{plan:?}");
    }

    #[test]
    fn what_breaks_next_to_an_end_is_marked_beside_it() {
        let locus = drawn(&["#####"; 5]);
        let mut field = field_of(&locus, 0.0).unwrap();
        let [from, _] = field.ends;
        assert_eq!(field.culprit(DVec3::new(0.5, 0.5, 0.0)), Some(12));
        for (at, wanted) in [([0.1, 0.0], 1), ([0.1, 0.1], 6), ([0.0, 0.1], 5)] {
            let at = DVec3::new(at[0], at[1], 0.0);
            assert_eq!(field.culprit(at), Some(wanted), "{at}");
            // Marked so, the end can still be left another way.
            let culprit = field.culprit(at).unwrap();
            assert_ne!(culprit, from);
            field.mark(&[culprit], 0.3);
        }
        assert!(!plan_in(&field).holds);
        assert_eq!(field.culprit(DVec3::new(-0.5, 0.0, 0.0)), None);
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
}
