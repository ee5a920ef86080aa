//! What a shuffle of codes would need on a shape that is put together of others, the connected-IST that Fujimoto et al.
//! name as future work and do not define; so that what is here is Frond's own reading of it. What is said of it on the
//! page of the deformation of space is tried here on small examples.

use std::collections::HashSet;

use frond_core::Affine3;
use frond_deform::{Corners3, shuffle};
use glam::{DQuat, DVec3};

/// An edge of a graph of states: from where to where. A code is a path along edges.
type Edge = (usize, usize);

fn paths(edges: &[Edge], length: usize) -> Vec<Vec<u8>> {
    let mut found = vec![Vec::new()];
    for _ in 0..length {
        let next = |path: &Vec<u8>| -> Vec<Vec<u8>> {
            let ends = path.last().map(|&edge| edges[usize::from(edge)].1);
            let fits = |&i: &usize| ends.is_none_or(|end| edges[i].0 == end);
            (0..edges.len()).filter(fits).map(|i| [&path[..], &[i as u8]].concat()).collect()
        };
        found = found.iter().flat_map(next).collect();
    }
    found
}

/// Whether the shuffle takes every path of so many edges to a path.
fn keeps_paths(edges: &[Edge], length: usize, kb: usize, ke: usize) -> bool {
    let all: HashSet<Vec<u8>> = paths(edges, length).into_iter().collect();
    all.iter().all(|path| {
        let mut moved = path.clone();
        shuffle(&mut moved, kb, ke);
        all.contains(&moved)
    })
}

fn strongly_connected(edges: &[Edge], states: usize) -> bool {
    let reaches = |from: usize| {
        let mut seen = HashSet::from([from]);
        for _ in 0..states {
            edges.iter().for_each(|&(a, b)| {
                if seen.contains(&a) {
                    seen.insert(b);
                }
            });
        }
        seen.len() == states
    };
    (0..states).all(reaches)
}

#[test]
fn reversed_words_are_codes_again_only_where_there_is_one_state() {
    let between: Vec<Edge> = (0..2).flat_map(|a| (0..2).map(move |b| (a, b))).collect();
    let mut looked_at = 0;
    // All graphs of two states with up to two arrows each way.
    for counts in 0..81_usize {
        let edges: Vec<Edge> = between
            .iter()
            .enumerate()
            .flat_map(|(i, &edge)| vec![edge; counts / 3_usize.pow(i as u32) % 3])
            .collect();
        if !strongly_connected(&edges, 2) {
            continue;
        }
        looked_at += 1;
        assert!(!keeps_paths(&edges, 4, 0, 2), "{edges:?}");
        assert!(!keeps_paths(&edges, 4, 1, 3), "{edges:?}");
    }
    assert!(looked_at > 20);
    for letters in 1..4 {
        let edges = vec![(0, 0); letters];
        assert!((0..4).all(|kb| (kb..=4).all(|ke| keeps_paths(&edges, 4, kb, ke))));
    }
}

#[test]
fn with_as_many_letters_at_every_state_their_numbers_are_shuffled_instead() {
    // Where the edges of each state are numbered alike, a path is the state it begins in and any word of numbers.
    let (states, letters, length) = (3_usize, 2_usize, 5_usize);
    let end = |state: usize, letter: u8| (2 * state + usize::from(letter) + 1) % states;
    let walk = |first: usize, word: &[u8]| word.iter().fold(first, |state, &letter| end(state, letter));
    let words: Vec<Vec<u8>> = (0..letters.pow(length as u32))
        .map(|number| (0..length).map(|k| (number >> k & 1) as u8).collect())
        .collect();
    for (kb, ke) in (0..=length).flat_map(|kb| (kb..=length).map(move |ke| (kb, ke))) {
        let moved: HashSet<Vec<u8>> = words
            .iter()
            .map(|word| {
                let mut moved = word.clone();
                shuffle(&mut moved, kb, ke);
                moved
            })
            .collect();
        assert_eq!(moved.len(), words.len(), "one to one and onto");
    }
    // But a shuffled word ends elsewhere, so that its tail is a point of another state's shape.
    let mut moved = vec![0, 1, 0, 0, 0];
    shuffle(&mut moved, 0, 2);
    assert_ne!(walk(0, &[0, 1, 0, 0, 0]), walk(0, &moved));
    // With two letters at one state and one at another, numbers are no code of their own.
    let golden = [(0, 0), (0, 1), (1, 0)];
    assert_eq!(paths(&golden, 3).len(), 8);
    assert!(!keeps_paths(&golden, 3, 0, 2));
}

#[test]
fn no_order_of_letters_but_the_given_one_is_continuous_on_the_gasket() {
    let corners = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
    let maps = corners.map(|c| Affine3::similitude(0.5, DQuat::IDENTITY, c * 0.5));
    assert!(Corners3::find(&maps).is_some());
    let letters = 4;
    let place = |code: &[u8], tail: u8| {
        code.iter()
            .rev()
            .fold(corners[usize::from(tail)], |point, &letter| maps[usize::from(letter)].apply(point))
    };
    // The two codes of the middle of an edge of a piece, w a b b b .. and w b a a a ..
    let mut orders: Vec<Vec<usize>> = vec![Vec::new()];
    for _ in 0..letters {
        orders = orders
            .iter()
            .flat_map(|order| {
                (0..letters).filter(|k| !order.contains(k)).map(|k| [&order[..], &[k]].concat())
            })
            .collect();
    }
    let continuous = |order: &[usize]| {
        (0..letters).all(|at| {
            let code = |a: u8, b: u8| -> Vec<u8> {
                (0..letters)
                    .map(|k| {
                        if k < at {
                            2
                        } else if k == at {
                            a
                        } else {
                            b
                        }
                    })
                    .collect()
            };
            let moved = |a: u8, b: u8| {
                let code = code(a, b);
                place(&order.iter().map(|&k| code[k]).collect::<Vec<_>>(), b)
            };
            assert!(place(&code(0, 1), 1).distance(place(&code(1, 0), 0)) < 1e-12);
            moved(0, 1).distance(moved(1, 0)) < 1e-9
        })
    };
    let found: Vec<_> = orders.into_iter().filter(|order| continuous(order)).collect();
    assert_eq!(found, [vec![0, 1, 2, 3]]);
}
