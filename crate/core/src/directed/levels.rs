//! How much the ways round through a graph shrink, and coordinates in which every arrow does.

/// An arrow of a graph: from one state into another, and the logarithm of how much it stretches.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Weight {
    pub into: usize,
    pub from: usize,
    pub log: f64,
}

/// Logarithms below this are not told apart: they stand for arrows that put all in one point.
const LEAST_LOG: f64 = -60.0;

/// The logarithm of a norm, of no norm as well.
pub(crate) fn log(norm: f64) -> f64 {
    norm.ln().max(LEAST_LOG)
}

/// The largest mean of the logarithms along a way round, and the arrows of one that has it (Karp 1978). None where
/// nothing leads round.
pub(crate) fn steepest(states: usize, weights: &[Weight]) -> Option<(f64, Vec<usize>)> {
    // The heaviest ways of so many arrows that end in each state, from anywhere, and the last arrow of each.
    let mut heaviest = vec![vec![0.0; states]];
    let mut last = vec![vec![usize::MAX; states]];
    for length in 0..states {
        let mut next = vec![f64::NEG_INFINITY; states];
        let mut arrows = vec![usize::MAX; states];
        for (k, weight) in weights.iter().enumerate() {
            let sum = heaviest[length][weight.from] + weight.log;
            if sum > next[weight.into] {
                next[weight.into] = sum;
                arrows[weight.into] = k;
            }
        }
        heaviest.push(next);
        last.push(arrows);
    }
    let mean = |state: usize| {
        let most = heaviest[states][state];
        let mean = |length: usize| (most - heaviest[length][state]) / (states - length) as f64;
        (0..states).filter(|&k| heaviest[k][state].is_finite()).map(mean).fold(f64::INFINITY, f64::min)
    };
    let reached = (0..states).filter(|&state| heaviest[states][state].is_finite());
    let (best, end) = reached.map(|state| (mean(state), state)).max_by(|a, b| a.0.total_cmp(&b.0))?;
    // The heaviest way of so many arrows passes some state twice: round there.
    let mut way = vec![end];
    let mut arrows = Vec::new();
    for length in (1..=states).rev() {
        let arrow = last[length][*way.last()?];
        arrows.push(arrow);
        way.push(weights[arrow].from);
    }
    let mut round: Option<(f64, Vec<usize>)> = None;
    for begin in 0..way.len() {
        for stop in begin + 1..way.len() {
            if way[begin] == way[stop] {
                let arrows = arrows[begin..stop].to_vec();
                let mean = arrows.iter().map(|&k| weights[k].log).sum::<f64>() / arrows.len() as f64;
                if round.as_ref().is_none_or(|(most, _)| mean > *most) {
                    round = Some((mean, arrows));
                }
                break;
            }
        }
    }
    round.map(|(_, arrows)| (best, arrows))
}

/// Logarithms of scales, one a state, such that every arrow stretches by no more than `most`: `scale of into + log -
/// scale of from <= most`. They exist where no way round has a mean above it, and are 0 where nothing asks for less.
pub(crate) fn scales(states: usize, weights: &[Weight], most: f64) -> Vec<f64> {
    let mut scales = vec![0.0_f64; states];
    for _ in 0..=states {
        let mut settled = true;
        for weight in weights {
            let limit = most - weight.log + scales[weight.from];
            if limit < scales[weight.into] {
                scales[weight.into] = limit;
                settled = false;
            }
        }
        if settled {
            break;
        }
    }
    scales
}

#[cfg(test)]
mod tests {
    use super::*;

    fn weights(arrows: &[(usize, usize, f64)]) -> Vec<Weight> {
        arrows.iter().map(|&(from, into, log)| Weight { into, from, log }).collect()
    }

    #[test]
    fn the_heaviest_way_round_is_found() {
        let graph =
            weights(&[(0, 1, 3.0), (1, 2, -1.0), (2, 0, -5.0), (1, 0, -4.0), (2, 2, -1.5), (0, 0, -2.0)]);
        let (mean, round) = steepest(3, &graph).unwrap();
        assert!((mean - -0.5).abs() < 1e-12, "{mean}");
        let mut round = round;
        round.sort_unstable();
        assert_eq!(round, [0, 3]);
        let least = scales(3, &graph, -0.4);
        for weight in &graph {
            assert!(least[weight.into] + weight.log - least[weight.from] <= -0.4 + 1e-12);
        }
        assert_eq!(scales(1, &weights(&[(0, 0, -1.0)]), -0.5), [0.0]);
    }

    #[test]
    fn a_graph_without_a_way_round_has_none() {
        assert!(steepest(2, &weights(&[(0, 1, 1.0)])).is_none());
    }
}
