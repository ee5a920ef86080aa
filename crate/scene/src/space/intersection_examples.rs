//! Two pairs of shapes that meet: in an attractor, and in none.

use crate::space::preset::Row3;

/// Two shapes, and whether their intersection is an attractor.
#[derive(Clone, Debug, PartialEq)]
pub struct IntersectionExample {
    /// Its name on screen.
    pub name: &'static str,
    /// The first shape.
    pub first: Vec<Row3>,
    /// The second shape.
    pub second: Vec<Row3>,
    /// Whether the intersection is the attractor of finitely many affine maps.
    pub is_attractor: bool,
    /// Why.
    pub why: &'static str,
}

/// Copies by a fifth, one for each place on a grid of fifths.
fn fifths(places: &[[u8; 3]]) -> Vec<Row3> {
    let row = |p: &[u8; 3]| {
        let [x, y, z] = p.map(|k| f64::from(k) / 5.0);
        [0.2, 0.0, 0.0, 0.0, 0.2, 0.0, 0.0, 0.0, 0.2, x, y, z]
    };
    places.iter().map(row).collect()
}

/// One example where the intersection is an attractor, and one where it is not.
#[must_use]
pub fn intersection_examples() -> Vec<IntersectionExample> {
    // Places with even numbers: no two of them are neighbours.
    let even: Vec<[u8; 3]> = (0..27).map(|k| [2 * (k % 3), 2 * (k / 3 % 3), 2 * (k / 9)]).collect();
    let middles = |p: &[u8; 3]| p.iter().filter(|&&k| k == 2).count();
    let sponge: Vec<[u8; 3]> = even.iter().copied().filter(|p| middles(p) < 2).collect();
    let shell: Vec<[u8; 3]> = even.iter().copied().filter(|p| middles(p) == 1 || middles(p) == 3).collect();
    let first =
        [[0, 0, 0], [1, 0, 0], [2, 0, 0], [3, 0, 0], [4, 0, 0], [7, 4, 0], [9, 4, 0], [5, 2, 0], [1, 1, 0]];
    let second =
        [[0, 4, 0], [1, 4, 0], [2, 4, 0], [3, 4, 0], [4, 4, 0], [7, 0, 0], [9, 0, 0], [5, 1, 0], [1, 2, 0]];
    vec![
        IntersectionExample {
            name: "A sponge and a shell",
            first: fifths(&sponge),
            second: fifths(&shell),
            is_attractor: true,
            why: "Both are made of copies, each a fifth as long, on places with even numbers. Two such pieces meet only if they are the same \
                  piece, so that a point of both has one address, of letters that both have. The intersection is the \
                  attractor of the twelve maps that the two share.",
        },
        IntersectionExample {
            name: "A bar and dust on one line",
            first: fifths(&first),
            second: fifths(&second),
            is_attractor: false,
            why: "The two touch along one line, in a bar from 1 to 1.2 and in a Cantor dust between 0.55 and 0.65. Suppose \
                  finitely many affine maps that shrink had this as their attractor. Those that put all of it in a point make \
                  finitely many points, so that some other map takes a point of the dust into the dust. It takes the line to \
                  itself; all of the dust to the dust, for the bar is too far away; and the bar into the bar, for the dust \
                  holds no interval. So the nearest points of bar and dust, 0.35 apart, go to points of bar and dust that \
                  are nearer. There are none.",
        },
    ]
}

#[cfg(test)]
mod tests {
    use frond_core::{Affine3, Intersection, intersection};
    use glam::DVec3;

    use super::*;

    fn product(example: &IntersectionExample) -> Intersection {
        let maps = |rows: &[Row3]| rows.iter().copied().map(Affine3::from_row).collect::<Vec<_>>();
        intersection(&maps(&example.first), &maps(&example.second)).unwrap()
    }

    #[test]
    fn the_sponge_and_the_shell_share_twelve_maps_and_nothing_else() {
        let example = &intersection_examples()[0];
        let found = product(example);
        assert!(example.is_attractor);
        assert_eq!(found.shifts, [DVec3::ZERO]);
        let maps = found.attractor().unwrap();
        assert_eq!(maps.len(), 12);
        for map in &maps {
            assert!(example.first.contains(&map.to_row()) && example.second.contains(&map.to_row()));
        }
    }

    #[test]
    fn the_bar_and_the_dust_are_what_is_said_of_them() {
        let example = &intersection_examples()[1];
        let found = product(example);
        assert!(!example.is_attractor && found.attractor().is_none() && !found.is_empty());
        // Two ways from no shift: up to the dust, and down to the bar.
        assert_eq!(found.arrows.iter().filter(|arrow| arrow.from == 0).count(), 2);
        let points = found.points(20_000, 3);
        let (points, _) = points.as_chunks::<3>();
        let (mut bar, mut dust) = (Vec::new(), Vec::new());
        for &[x, y, z] in points {
            assert!((y - 0.4).abs() < 1e-5 && z.abs() < 1e-6, "{x} {y} {z}");
            if x > 0.9 { bar.push(x) } else { dust.push(x) }
        }
        for (part, low, high, widest) in [(&mut bar, 1.0, 1.2, 0.003), (&mut dust, 0.55, 0.65, 0.08)] {
            part.sort_by(f32::total_cmp);
            assert!(part.len() > 5000);
            assert!((part[0] - low).abs() < 1e-3 && (part[part.len() - 1] - high).abs() < 1e-3);
            let gap = part.windows(2).map(|two| two[1] - two[0]).fold(0.0, f32::max);
            assert!(gap < widest);
        }
        // The dust has a hole in its middle, three fifths of its size.
        let hole = dust.windows(2).map(|two| two[1] - two[0]).fold(0.0, f32::max);
        assert!((hole - 0.06).abs() < 1e-3, "{hole}");
    }
}
