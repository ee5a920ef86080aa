//! How large the states of a graph-directed system and their copies are.

use crate::dimension::{Dim2, Dimension};
use crate::directed::map::DirectedMap;
use crate::directed::reach;
use crate::ifs::fractal_dimension::falconer;
use crate::ifs::probabilities::shared;

/// Beyond this nobody asks: maps that stretch at first may need any s.
const MOST_DIMENSION: f64 = 64.0;

/// The dimension of a class of states that are made of each other; an upper bound where maps are no similitudes.
pub(crate) fn dimension_of_class(states: &[Vec<DirectedMap>], classes: &[usize], label: usize) -> f64 {
    let members: Vec<usize> = (0..states.len()).filter(|&state| classes[state] == label).collect();
    let size = members.len();
    let mut places = vec![None; states.len()];
    for (row, &state) in members.iter().enumerate() {
        places[state] = Some(row);
    }
    let place = |state: usize| places[state];
    let sizes: Vec<([usize; 2], [f64; 2])> = members
        .iter()
        .enumerate()
        .flat_map(|(row, &state)| {
            states[state].iter().filter_map(move |part| {
                Some(([row, place(part.from)?], Dim2::singular_values(part.map.linear)))
            })
        })
        .collect();
    let exceeds = |s: f64| {
        let matrix: Vec<([usize; 2], f64)> =
            sizes.iter().map(|(at, values)| (*at, falconer(values, s))).collect();
        exceeds_one(&matrix, size)
    };
    if exceeds(MOST_DIMENSION) {
        return f64::INFINITY;
    }
    let (mut low, mut high) = (0.0, MOST_DIMENSION);
    for _ in 0..60 {
        let middle = f64::midpoint(low, high);
        if exceeds(middle) { low = middle } else { high = middle }
    }
    f64::midpoint(low, high)
}

/// Whether the spectral radius of a matrix without negative numbers, of states that all lead to each other, is above 1.
/// It is given by its entries, each a row, a column and a number; those of one place add up.
///
/// By powers of the matrix and the identity: the least and the largest factor by which an entry grows are bounds at
/// every step (Collatz & Wielandt).
fn exceeds_one(matrix: &[([usize; 2], f64)], size: usize) -> bool {
    let mut vector = vec![1.0; size];
    let mut middle = 0.0;
    for _ in 0..2000 {
        let mut next = vector.clone();
        for ([row, column], factor) in matrix {
            next[*row] += factor * vector[*column];
        }
        let growth = || next.iter().zip(&vector).map(|(new, old)| new / old - 1.0);
        let (low, high) = (growth().fold(f64::INFINITY, f64::min), growth().fold(0.0, f64::max));
        if low > 1.0 || high <= 1.0 {
            return low > 1.0;
        }
        middle = f64::midpoint(low, high);
        if high - low < 1e-15 {
            break;
        }
        let largest = next.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
        vector = next.into_iter().map(|x| (x / largest).max(1e-250)).collect();
    }
    middle > 1.0
}

/// How probable each map of each state is: as its copy is large, at the dimension where all of them together stay as
/// large as they are. A copy that is nearly nothing still gets a little, or it would never show.
pub(crate) fn probabilities(states: &[Vec<DirectedMap>]) -> Vec<Vec<f64>> {
    let classes = reach::classes(states);
    let labels = (0..states.len()).filter(|&i| classes[i] == i);
    let dimension =
        labels.map(|label| dimension_of_class(states, &classes, label)).fold(0.0, f64::max).min(2.0);
    let sizes: Vec<Vec<f64>> = states
        .iter()
        .map(|maps| {
            maps.iter().map(|part| falconer(&Dim2::singular_values(part.map.linear), dimension)).collect()
        })
        .collect();
    let weigh = |state: usize, measure: &[f64]| -> Vec<f64> {
        states[state].iter().zip(&sizes[state]).map(|(part, size)| size * measure[part.from]).collect()
    };
    let mut measure = vec![1.0; states.len()];
    for _ in 0..200 {
        // Half of what it was: where states only change places nothing else would come to rest.
        let next: Vec<f64> =
            (0..states.len()).map(|i| 0.5 * (measure[i] + weigh(i, &measure).iter().sum::<f64>())).collect();
        let largest = next.iter().copied().fold(0.0, f64::max);
        if !(largest > 0.0 && largest.is_finite()) {
            measure.fill(1.0);
            break;
        }
        measure = next.into_iter().map(|x| x / largest).collect();
    }
    let fair = |state: usize| {
        let weights = weigh(state, &measure);
        let total: f64 = weights.iter().sum();
        // Dust beside a shape of more dimensions has no part of it.
        let weights = if total > 1e-200 && total.is_finite() { weights } else { vec![1.0; weights.len()] };
        let total: f64 = weights.iter().sum();
        shared(weights, 0.01 * total)
    };
    (0..states.len()).map(fair).collect()
}
