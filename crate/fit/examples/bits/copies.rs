//! What copies would save: runs of nodes that are left out, where a smaller image of another part stands for them.

use frond_fit::{Outline, Spline, StepLaw, fidelity};
use glam::{DMat2, DVec2};

/// What a bit more on each node is worth in squares, for each point: what the curve itself was made with.
const PRICE: f64 = 0.02;

/// Sides of a parabola.
const SIDES: usize = 6;

/// The longest run and the longest source, in nodes.
const LONGEST: usize = 12;

/// Bits of the factor across the chord, and of mirror and way.
const SHAPE_BITS: f64 = 5.0;

/// One copy that is worth it.
struct Worth {
    from: usize,
    to: usize,
    source: usize,
    /// What it saves in bits, squares counted by their price, and without them.
    saved: f64,
    shorter: f64,
    /// Its corners.
    image: Vec<DVec2>,
}

/// The sum of squares of points from a polyline; anything more than `most` where it is more.
fn squares(points: &[DVec2], line: &[DVec2], most: f64) -> f64 {
    let side = |p: DVec2, w: &[DVec2]| {
        let chord = w[1] - w[0];
        let share = ((p - w[0]).dot(chord) / chord.length_squared().max(1e-12)).clamp(0.0, 1.0);
        (p - w[0] - chord * share).length_squared()
    };
    let mut sum = 0.0;
    // Those in the middle first: there it is seen soonest.
    let count = points.len();
    for k in 0..count {
        let at = if k % 2 == 0 { count / 2 + k / 2 } else { count / 2 - k.div_ceil(2) };
        let Some(&p) = points.get(at) else { continue };
        sum += line.windows(2).map(|w| side(p, w)).fold(f64::INFINITY, f64::min);
        if sum > most {
            break;
        }
    }
    sum
}

/// Where arcs of the curve copy others, each charged what it costs by the price that the curve itself was made with:
/// what the best of them come to, measured, where their sources are any arcs; and what is saved by that price where
/// they share a few sources. Sources are taken as they were, so that this is the most that copies of copies come to.
pub fn worth(outline: &Outline, spline: &Spline) -> String {
    // All in steps of the grid.
    let points: Vec<DVec2> = outline.points().iter().map(|p| *p / spline.grid).collect();
    let spline = &Spline { grid: 1.0, ..spline.clone() };
    let nodes = &spline.nodes;
    let Some(marks) = spline.beside(&points) else { return "too long to look for copies".to_owned() };
    let count = nodes.len();
    let step = |i: usize| nodes[i % count].at - nodes[(i + count - 1) % count].at;
    let law = StepLaw::of((0..count).map(|i| (step(i), step(i + count - 1))));
    let share = spline.corners() as f64 / count as f64;
    let kind = |on: bool| if on { -share.log2() } else { -(1.0 - share).log2() };
    let bits = |i: usize| law.bits(step(i), step(i + count - 1)) + kind(nodes[i % count].on);
    let price = PRICE * points.len() as f64 / count as f64;
    let between = |a: usize, b: usize| {
        let (first, last) = (marks[a % count], marks[b % count]);
        let many = (last + points.len() - first) % points.len();
        (0..=many).map(|k| points[(first + k) % points.len()]).collect::<Vec<_>>()
    };
    let arc = |a: usize, b: usize| {
        let mut line = spline.stretch(a, b, SIDES);
        // From the node itself, and to the node itself.
        line[0] = nodes[a % count].at;
        let last = line.len() - 1;
        line[last] = nodes[b % count].at;
        line
    };
    let mut all: Vec<Worth> = Vec::new();
    for from in 0..count {
        if !nodes[from].on {
            continue;
        }
        for long in 2..=LONGEST.min(count / 3) {
            let to = from + long;
            if !nodes[to % count].on {
                continue;
            }
            let there = between(from, to);
            let now = squares(&there, &arc(from, to), f64::INFINITY);
            let spent: f64 = (from + 1..to).map(bits).sum();
            let cost = (count as f64).log2() + 3.0 + SHAPE_BITS;
            // Of few shared sources a copy would be named in fewer bits.
            let allowed = spent - 2.0 - SHAPE_BITS;
            if allowed <= 0.0 {
                continue;
            }
            let chord = nodes[to % count].at - nodes[from].at;
            let aim = moments(&there, nodes[from].at, chord);
            for source in 0..count {
                if !nodes[source].on {
                    continue;
                }
                for wide in 2..=LONGEST.min(count / 3) {
                    let end = source + wide;
                    // Apart from what it replaces, and larger.
                    let apart = (source + count - from) % count >= long
                        && (source + count - from) % count + wide <= count;
                    let whole = nodes[end % count].at - nodes[source].at;
                    if !apart
                        || !nodes[end % count].on
                        || chord.length_squared() > 0.8 * whole.length_squared()
                    {
                        continue;
                    }
                    let line = arc(source, end);
                    let shape = moments(&line, nodes[source].at, whole);
                    for mirrored in [1.0, -1.0] {
                        for reversed in [false, true] {
                            // A rough look first: area under the arcs, which a factor makes alike.
                            let area = if shape.abs() > 1e-3 { aim / shape } else { 0.0 };
                            let c = (area.abs() * 4.0).round().clamp(1.0, 8.0) / 4.0 * mirrored;
                            let spin = |z: DVec2| DMat2::from_cols(z, z.perp());
                            let unit = |z: DVec2| {
                                DVec2::new(z.dot(whole), whole.perp_dot(z)) / whole.length_squared()
                            };
                            let mut image: Vec<DVec2> = line
                                .iter()
                                .map(|p| {
                                    let w = unit(*p - nodes[source].at);
                                    let w = if reversed { DVec2::new(1.0 - w.x, -w.y) } else { w };
                                    nodes[from].at + spin(chord) * DVec2::new(w.x, w.y * c)
                                })
                                .collect();
                            if reversed {
                                image.reverse();
                            }
                            let next = squares(&there, &image, now + price * allowed);
                            let saved = spent - cost - (next - now) / price;
                            if saved + cost - 2.0 - SHAPE_BITS > 0.0 {
                                let shorter = spent - cost;
                                all.push(Worth {
                                    from,
                                    to,
                                    source: source * 64 + wide,
                                    saved,
                                    shorter,
                                    image,
                                });
                            }
                        }
                    }
                }
            }
        }
    }
    all.sort_by(|a, b| b.saved.total_cmp(&a.saved));
    let total: f64 = (0..count).map(bits).sum();
    let picked = chosen(&all, count, 0.0, None);
    // Few sources, named once each: the rest of a copy's name is one of them.
    let mut sources: Vec<usize> = Vec::new();
    let cheaper = (count as f64).log2() + 3.0;
    let mut best = (0, 0.0);
    for _ in 0..8 {
        let mut left: Vec<usize> = all.iter().map(|worth| worth.source).collect();
        left.sort_unstable();
        left.dedup();
        let tried = left.into_iter().map(|source| {
            let mut with = sources.clone();
            with.push(source);
            let bonus = cheaper - (with.len() as f64).log2();
            let picked = chosen(&all, count, bonus, Some(&with));
            let saved = saved_by(&picked, count, bonus, |worth| worth.saved);
            (source, picked.len(), saved - cheaper * with.len() as f64)
        });
        let Some((source, many, saved)) = tried.max_by(|a, b| a.2.total_cmp(&b.2)) else { break };
        sources.push(source);
        if saved > best.1 {
            best = (many, saved);
        }
    }
    let shared = format!("of few shared sources {} save {:.1}%", best.0, 100.0 * best.1 / total);
    let Ok(outline) = Outline::new(&points) else { return shared };
    let rms = |line: &[DVec2]| fidelity(&outline, line).rms;
    format!(
        "{} copies: {total:.0} bits become {:.0}, rms {:.4} becomes {:.4}; {shared}",
        picked.len(),
        total - saved_by(&picked, count, 0.0, |worth| worth.shorter),
        rms(&spline.polyline(16)),
        rms(&with(spline, &picked)),
    )
}

/// The curve with copies in the place of what they stand for.
fn with(spline: &Spline, picked: &[&Worth]) -> Vec<DVec2> {
    let nodes = &spline.nodes;
    let count = nodes.len();
    let mut line = Vec::new();
    // From where no copy runs over the end.
    let first = (0..count).find(|&i| {
        picked
            .iter()
            .all(|worth| (i + count - worth.from) % count >= worth.to - worth.from || i == worth.from)
    });
    let first = first.unwrap_or(0);
    let mut i = first;
    while i < first + count {
        if let Some(worth) = picked.iter().find(|worth| worth.from == i % count) {
            line.extend_from_slice(&worth.image[..worth.image.len() - 1]);
            i += worth.to - worth.from;
        } else {
            let arc = spline.stretch(i, i, SIDES);
            // A corner's own piece begins and ends on straight sides.
            let corner = [nodes[i % count].at];
            line.extend_from_slice(if nodes[i % count].on { &corner } else { &arc[..arc.len() - 1] });
            i += 1;
        }
    }
    line
}

/// What copies save, less what it takes to say of each node whether one begins there.
fn saved_by(picked: &[&Worth], count: usize, bonus: f64, of: impl Fn(&Worth) -> f64) -> f64 {
    let share = (picked.len() as f64 + 0.5) / (count as f64 + 1.0);
    let flags = -(count as f64) * (share * share.log2() + (1.0 - share) * (1.0 - share).log2());
    picked.iter().map(|worth| of(worth) + bonus).sum::<f64>() - flags
}

/// The best copies that do not overlap, when each is cheaper by `bonus`.
fn chosen<'a>(all: &'a [Worth], count: usize, bonus: f64, sources: Option<&[usize]>) -> Vec<&'a Worth> {
    let mut taken = vec![false; count];
    let mut picked = Vec::new();
    for worth in all {
        if sources.is_some_and(|sources| !sources.contains(&worth.source)) {
            continue;
        }
        let inside = || (worth.from..worth.to).map(|i| i % count);
        if worth.saved + bonus <= 0.0 || inside().any(|i| taken[i]) {
            continue;
        }
        inside().for_each(|i| taken[i] = true);
        picked.push(worth);
    }
    picked
}

/// The mean height over a chord, in parts of its length.
fn moments(points: &[DVec2], from: DVec2, chord: DVec2) -> f64 {
    let sum: f64 = points.iter().map(|p| chord.perp_dot(*p - from)).sum();
    sum / (points.len() as f64 * chord.length_squared().max(1e-12))
}
