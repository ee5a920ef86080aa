//! A plan that holds as far as epsilon tells may break by less. The lines u = 0 and u = 1, v = 0 and v = 1 through its
//! ends are worth a try then: on each of them either the linear parts or the translations are those of an end, and
//! shapes often hold there exactly (three halves do, wherever they lie), while samples beside the line are broken.

use frond_core::along;
use glam::DVec3;

use crate::path::check::{Parameters, judge};
use crate::path::field::Field;
use crate::path::plan::{ENDS, PathPlan, clearance};
use crate::verdict::{Sample, State};

/// How much finer than epsilon it looks.
const FINER: f64 = 4096.0;
/// Parameters decided along each way at first.
const FEW_CHECKS: usize = 200;
/// Parameters decided along those that did best.
const MANY_CHECKS: usize = 4000;
/// How many did best.
const BEST: usize = 6;
/// Places of the plan from which a line is tried.
const PLACES: usize = 20;
/// Where the line is met: so far from the nearest place of it.
const ASIDE: [f64; 5] = [0.0, 0.05, -0.05, 0.1, -0.1];
/// A way is taken in place of the plan if its widest gap is this part of the plan's, or less.
const WORTH: f64 = 0.5;

/// The plan, or one that takes to a line through an end early, where that breaks by less. The plan must hold.
pub(crate) fn by_end_lines(
    morph: &impl Parameters,
    field: &Field,
    mut plan: PathPlan,
    epsilon: f64,
    checks: usize,
) -> PathPlan {
    let fine = epsilon / FINER;
    // The second end first: there most morphs get thin.
    for end in [1, 0] {
        let at_first = widest(morph, &plan.points, fine, FEW_CHECKS, f64::INFINITY);
        if at_first == 0.0 {
            continue;
        }
        // The last places first: the plan is to stay as it is as far as can be.
        let places = (1..PLACES).rev().flat_map(|k| ASIDE.map(|aside| (k as f64 / PLACES as f64, aside)));
        let mut ways: Vec<(f64, Vec<DVec3>)> = places
            .flat_map(|(t, aside)| Line::BOTH.map(|line| line.reached(&plan.points, end, t, aside)))
            .filter(|way| way.len() <= PathPlan::MOST_POINTS.max(plan.points.len()) && on_the_map(field, way))
            .map(|way| (widest(morph, &way, fine, FEW_CHECKS, at_first), way))
            .filter(|&(gap, _)| gap < at_first)
            .collect();
        // Stable: of equal ones the first.
        ways.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut least = WORTH * at_first;
        let mut best = None;
        for (_, way) in ways.into_iter().take(BEST) {
            let gap = widest(morph, &way, fine, MANY_CHECKS, least);
            if gap < least && judge(morph, &way, epsilon, checks, |_| ()).holds {
                least = gap;
                best = Some(way);
            }
            if least == 0.0 {
                break;
            }
        }
        if let Some(points) = best {
            plan = PathPlan { clearance: clearance(field, &points), points, ..plan };
        }
    }
    plan
}

/// Whether a way stays where samples tell what lies beside it.
fn on_the_map(field: &Field, way: &[DVec3]) -> bool {
    way.iter().all(|&at| field.lattice.cell(field.lattice.fraction(at)).is_some())
}

/// A line through an end, along one axis.
#[derive(Clone, Copy)]
enum Line {
    /// Of one u: the linear parts are those of the end.
    Upright,
    /// Of one v: the translations are those of the end.
    Level,
}

impl Line {
    const BOTH: [Self; 2] = [Self::Upright, Self::Level];

    /// The way that leaves the points at a fraction of their length straight for the line, and follows it to the end.
    /// For the first end the same backwards.
    fn reached(self, points: &[DVec3], end: usize, t: f64, aside: f64) -> Vec<DVec3> {
        let mut points = points.to_vec();
        if end == 0 {
            points.reverse();
        }
        let place = along(&points, t);
        let mut way = points;
        way.truncate(1 + corners_before(&way, t));
        let on_line = match self {
            Self::Upright => DVec3::new(ENDS[end].x, place.y + aside, ENDS[end].z),
            Self::Level => DVec3::new(place.x + aside, ENDS[end].y, ENDS[end].z),
        };
        way.extend([place, on_line, ENDS[end]]);
        way.dedup();
        if end == 0 {
            way.reverse();
        }
        way
    }
}

/// How many corners after the first lie before a fraction of the length.
fn corners_before(points: &[DVec3], t: f64) -> usize {
    let length = |points: &[DVec3]| points.windows(2).map(|leg| leg[0].distance(leg[1])).sum::<f64>();
    let far = t * length(points);
    (1..points.len()).take_while(|&k| length(&points[..=k]) < far).count()
}

/// The widest gap seen along a way, or a number that is `limit` or more once it is that wide.
fn widest<P: Parameters>(morph: &P, points: &[DVec3], epsilon: f64, checks: usize, limit: f64) -> f64 {
    let mut memory = P::Memory::default();
    let mut widest = 0.0_f64;
    // Spread over the way from the first, so that what is too wide is seen soon.
    for k in 0..checks {
        let t = (k as f64 * GOLDEN_RATIO).fract();
        widest = widest.max(seen(morph.sample(along(points, t), epsilon, &mut memory)));
        if widest >= limit {
            break;
        }
    }
    widest
}

/// The gap that is known to be there: none where so fine a question was not answered.
fn seen(sample: Sample) -> f64 {
    match sample.state {
        State::Disconnected => f64::from(sample.gap),
        State::NoAttractor => f64::INFINITY,
        State::Connected | State::Touching | State::Undecided => 0.0,
    }
}

/// Its multiples, less their whole parts, lie evenly between 0 and 1, however many are taken.
const GOLDEN_RATIO: f64 = 0.618_033_988_749_894_8;
