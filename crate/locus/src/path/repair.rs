//! A plan is checked between the samples it was made from, and made again around what is broken there.

use crate::path::check::{Parameters, PathCheck, judge};
use crate::path::field::Field;
use crate::path::plan::{PathPlan, ROOM_SHARE, clearance, plan_in};

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
    morph: &impl Parameters,
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

/// A plan that holds, without the corners that it can do without: the legs instead of them are decided themselves,
/// which tells more than the samples around them.
fn straightened(morph: &impl Parameters, field: &Field, mut plan: PathPlan, epsilon: f64) -> PathPlan {
    let mut k = 1;
    while k + 1 < plan.points.len() {
        let leg = [plan.points[k - 1], plan.points[k + 1]];
        let samples = (CHECKS_PER_SAMPLE * leg[0].distance(leg[1]) / field.step()).ceil().min(1e4) as usize;
        let shortcut = clearance(field, &leg) >= ROOM_SHARE * plan.clearance
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
const CHECKS_PER_SAMPLE: f64 = 16.0;
/// Parameters decided along a plan, at least.
pub(crate) const LEAST_CHECKS: usize = 2048;
/// How often a plan is mended before a finer locus is taken.
pub(crate) const MOST_REPAIRS: usize = 8;
