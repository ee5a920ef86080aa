//! The exponent at which a weighted graph neither grows nor decays, between rigorous bounds.

use crate::number::interval::Interval;

/// A step of a graph: from, to, how often, and what it scales lengths by.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Weighted {
    pub from: usize,
    pub to: usize,
    pub weight: Interval,
    pub ratio: Interval,
}

const ROUNDS: usize = 400;

/// Bounds of the s at which the matrix of the sums of `weight ratio^s` has spectral radius one (Mauldin & Williams
/// 1988). `None` where nothing goes round; zero where all that goes round does so in one way alone.
pub(crate) fn exponent(size: usize, steps: &[Weighted], most: f64) -> Option<(f64, f64)> {
    let mut best: Option<(f64, f64)> = None;
    for part in components(size, steps) {
        if let Some((lower, upper)) = of_component(&part.0, &part.1, most) {
            best = Some(best.map_or((lower, upper), |(l, u)| (l.max(lower), u.max(upper))));
        }
    }
    best
}

fn of_component(members: &[usize], steps: &[Weighted], most: f64) -> Option<(f64, f64)> {
    if steps.is_empty() {
        return None;
    }
    let n = members.len();
    let radius = |s: f64| {
        let entries: Vec<f64> = steps.iter().map(|e| e.weight.middle() * e.ratio.middle().powf(s)).collect();
        eigenvector(n, steps, &entries)
    };
    let (mut low, mut high) = (0.0, most + 1.0);
    for _ in 0..60 {
        let middle = f64::midpoint(low, high);
        if radius(middle).0 > 1.0 { low = middle } else { high = middle }
    }
    let near = f64::midpoint(low, high);
    let mut room = 1e-14;
    while room < 1.0 {
        let (lower, upper) = ((near - room).max(0.0), near + room);
        let below = lower == 0.0 || bounds(n, steps, lower, &radius(lower).1).0 >= 1.0;
        if below && bounds(n, steps, upper, &radius(upper).1).1 <= 1.0 {
            return Some((lower, upper));
        }
        room *= 2.0;
    }
    // What goes round without a loss has no bound from above here.
    Some((0.0, f64::INFINITY))
}

/// The spectral radius and its vector, near enough to be checked.
fn eigenvector(n: usize, steps: &[Weighted], entries: &[f64]) -> (f64, Vec<f64>) {
    let (mut vector, mut radius) = (vec![1.0; n], 1.0);
    for _ in 0..ROUNDS {
        let mut next = vector.clone();
        for (step, entry) in steps.iter().zip(entries) {
            next[step.from] += entry * vector[step.to];
        }
        let total: f64 = next.iter().sum();
        let before: f64 = vector.iter().sum();
        next.iter_mut().for_each(|x| *x *= n as f64 / total);
        radius = total / before - 1.0;
        let change = next.iter().zip(&vector).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        vector = next;
        if change < 1e-15 {
            break;
        }
    }
    (radius, vector)
}

/// The least and the largest growth of an entry, between which the spectral radius is (Collatz & Wielandt).
fn bounds(n: usize, steps: &[Weighted], s: f64, vector: &[f64]) -> (f64, f64) {
    let mut image = vec![Interval::ZERO; n];
    for step in steps {
        let entry = if s == 0.0 { step.weight } else { step.weight * step.ratio.power(Interval::point(s)) };
        image[step.from] = image[step.from] + entry * Interval::point(vector[step.to]);
    }
    let growth = image.iter().zip(vector).map(|(x, v)| *x / Interval::point(*v));
    growth.fold((f64::INFINITY, 0.0f64), |(low, high), x| (low.min(x.lower()), high.max(x.upper())))
}

type Component = (Vec<usize>, Vec<Weighted>);

/// The strongly connected components with their own steps, members counted anew (Kosaraju).
pub(crate) fn components(size: usize, steps: &[Weighted]) -> Vec<Component> {
    let (mut out, mut back) = (vec![Vec::new(); size], vec![Vec::new(); size]);
    for step in steps {
        out[step.from].push(step.to);
        back[step.to].push(step.from);
    }
    let (mut order, mut seen) = (Vec::new(), vec![false; size]);
    for start in 0..size {
        if std::mem::replace(&mut seen[start], true) {
            continue;
        }
        let mut stack = vec![(start, 0)];
        while let Some((at, k)) = stack.pop() {
            if let Some(&to) = out[at].get(k) {
                stack.push((at, k + 1));
                if !std::mem::replace(&mut seen[to], true) {
                    stack.push((to, 0));
                }
            } else {
                order.push(at);
            }
        }
    }
    let mut part = vec![usize::MAX; size];
    let mut place = vec![0; size];
    let mut parts: Vec<Component> = Vec::new();
    for &start in order.iter().rev().filter(|&&k| size > k) {
        if part[start] != usize::MAX {
            continue;
        }
        let (number, mut members, mut stack) = (parts.len(), Vec::new(), vec![start]);
        part[start] = number;
        while let Some(at) = stack.pop() {
            place[at] = members.len();
            members.push(at);
            for &to in &back[at] {
                if part[to] == usize::MAX {
                    part[to] = number;
                    stack.push(to);
                }
            }
        }
        parts.push((members, Vec::new()));
    }
    for step in steps.iter().filter(|step| part[step.from] == part[step.to]) {
        let own = Weighted { from: place[step.from], to: place[step.to], ..*step };
        parts[part[step.from]].1.push(own);
    }
    parts
}
