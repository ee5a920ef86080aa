//! The means of a displacement over the pieces of a shape, exactly.

use frond_core::{Affine2, Ifs};
use glam::{DMat2, DVec2};

use crate::mesh::Mesh;
use crate::shuffle::moments::{Substitution, centroid, monomials, of_shape, slot};

/// Means that are summed together: as many as a vector register or two hold.
const LANES: usize = 8;

/// Means over all words of so many letters, one for each: of the displacement F_v over the points of the piece, which
/// are counted as the chaos game throws them.
///
/// F_v is a polynomial, so that its mean over a piece is a sum of moments of the shape. A word is cut into a head and a
/// tail: F_v behind the head is a polynomial again, and the moments of the piece that the tail names are its means. So
/// the heads and the tails cost what they cost, and each word a product of two short lists.
#[derive(Clone, Debug)]
pub(crate) struct Means {
    heads: Vec<Affine2>,
    /// For each monomial the moments of all tails, and zeros up to whole blocks.
    moments: Vec<f64>,
    tails: usize,
    /// The total degree of the polynomials.
    degree: usize,
    /// From the coordinates of the moments, in which the shape has its middle in the origin and a size of 1, to the
    /// plane.
    to_plane: Affine2,
}

impl Means {
    /// For words of so many letters and meshes of the same size as this; the box holds the shape.
    pub fn new(ifs: &Ifs, letters: usize, mesh: &Mesh, (low, high): (DVec2, DVec2)) -> Self {
        let degree = mesh.columns() + mesh.rows() - 2;
        let size = (high - low).max_element();
        let size = if size > 0.0 && size.is_finite() { size } else { 1.0 };
        let middle = centroid(ifs).unwrap_or(0.5 * (low + high));
        let to_plane = Affine2::new(DMat2::from_diagonal(DVec2::splat(size)), middle);
        let behind = |map: &Affine2| Affine2::new(map.linear, (map.apply(middle) - middle) / size);
        let maps: Vec<_> = ifs.maps().iter().map(|map| Substitution::new(&behind(map), degree)).collect();
        let mut moments = of_shape(&maps, ifs.probabilities());
        let mut tails = 1;
        for _ in 0..letters - letters / 2 {
            // One letter more in front: the images of the pieces so far.
            let all = tails * maps.len();
            let mut images = vec![0.0; monomials(degree) * all];
            for (i, map) in maps.iter().enumerate() {
                map.images(&moments, tails, &mut images[i * tails..], all);
            }
            (moments, tails) = (images, all);
        }
        let mut blocks = Vec::new();
        for moments in moments.chunks_exact(tails) {
            blocks.extend_from_slice(moments);
            blocks.resize(blocks.len().next_multiple_of(LANES), 0.0);
        }
        Self { heads: words(ifs.maps(), letters / 2), moments: blocks, tails, degree, to_plane }
    }

    /// The middle of the shape; that of a piece is its image.
    pub const fn middle(&self) -> DVec2 {
        self.to_plane.translation
    }

    /// How many words.
    pub const fn count(&self) -> usize {
        self.heads.len() * self.tails
    }

    /// The means for all words, in their order.
    pub fn of(&self, mesh: &Mesh) -> Vec<DVec2> {
        let mut list = vec![DVec2::ZERO; self.count()];
        let mut behind = vec![DVec2::ZERO; monomials(self.degree)];
        for (head, list) in self.heads.iter().zip(list.chunks_exact_mut(self.tails)) {
            expand(mesh, &(*head * self.to_plane), &mut behind);
            for (block, list) in list.chunks_mut(LANES).enumerate() {
                let (mut x, mut y) = ([0.0; LANES], [0.0; LANES]);
                let stride = self.tails.next_multiple_of(LANES);
                for (term, moments) in behind.iter().zip(self.moments.chunks_exact(stride)) {
                    let moments = &moments[block * LANES..(block + 1) * LANES];
                    for lane in 0..LANES {
                        x[lane] += term.x * moments[lane];
                        y[lane] += term.y * moments[lane];
                    }
                }
                list.iter_mut().zip(x.into_iter().zip(y)).for_each(|(mean, pair)| *mean = pair.into());
            }
        }
        list
    }
}

/// The maps of all words of so many letters, in their order.
pub(crate) fn words(maps: &[Affine2], letters: usize) -> Vec<Affine2> {
    (0..letters).fold(vec![Affine2::IDENTITY], |words, _| {
        words.iter().flat_map(|word| maps.iter().map(move |map| *word * *map)).collect()
    })
}

/// The displacement behind a map as a polynomial: the coefficients of the monomials of the point that is mapped.
fn expand(mesh: &Mesh, map: &Affine2, sum: &mut [DVec2]) {
    let (low, high) = mesh.bounds();
    let scale = (high - low).recip();
    let (columns, rows) = (mesh.columns(), mesh.rows());
    let place = (map.translation - low) * scale;
    let (across, up) = (bernstein_about(place.x, columns), bernstein_about(place.y, rows));
    // The parameters of the mesh as linear forms, and their powers.
    let forms = DMat2::from_diagonal(scale) * map.linear;
    let (across_powers, up_powers) = (powers(forms.row(0), columns), powers(forms.row(1), rows));
    sum.fill(DVec2::ZERO);
    for a in 0..columns {
        let mut column = [DVec2::ZERO; Mesh::LARGEST];
        for (slot, row) in column.iter_mut().zip(mesh.displacements().chunks_exact(columns)) {
            *slot = row.iter().zip(&across[a]).map(|(d, share)| *d * *share).sum();
        }
        for b in 0..rows {
            let term: DVec2 = column[..rows].iter().zip(&up[b]).map(|(d, share)| *d * *share).sum();
            let sum = &mut sum[slot(a + b, 0)..=slot(0, a + b)];
            for (k, x) in across_powers[a][..=a].iter().enumerate() {
                let term = term * *x;
                sum[k..].iter_mut().zip(&up_powers[b][..=b]).for_each(|(sum, y)| *sum += term * *y);
            }
        }
    }
}

/// A square of numbers for each mesh there is.
type Square = [[f64; Mesh::LARGEST]; Mesh::LARGEST];

/// The powers 0 to `count - 1` of a linear form x h + y k: of each the numbers at its monomials, powers of h first.
fn powers(form: DVec2, count: usize) -> Square {
    let mut list = [[0.0; Mesh::LARGEST]; Mesh::LARGEST];
    list[0][0] = 1.0;
    for n in 1..count {
        for i in 0..n {
            let number = list[n - 1][i];
            list[n][i] += form.x * number;
            list[n][i + 1] += form.y * number;
        }
    }
    list
}

/// The Bernstein polynomials of degree `count - 1` about `t`: for each power of the distance from there, what each has.
fn bernstein_about(t: f64, count: usize) -> Square {
    let mut list = [[0.0; Mesh::LARGEST]; Mesh::LARGEST];
    list[0][0] = 1.0;
    // De Casteljau's triangle as in the mesh, with t + s for t and s unknown.
    for degree in 1..count {
        for power in (0..=degree).rev() {
            for i in (0..=degree).rev() {
                let mut number = list[power][i] * (1.0 - t);
                if i > 0 {
                    number += list[power][i - 1] * t;
                }
                if power > 0 {
                    number -= list[power - 1][i];
                }
                if i > 0 && power > 0 {
                    number += list[power - 1][i - 1];
                }
                list[power][i] = number;
            }
        }
    }
    list
}

#[cfg(test)]
mod tests {
    use frond_core::Hull;
    use proptest::prelude::*;

    use super::*;

    fn means(maps: &[Affine2], letters: usize, mesh: &Mesh) -> Vec<DVec2> {
        let ifs = Ifs::new(maps.to_vec()).unwrap();
        let hull = Hull::of(&ifs);
        let means = Means::new(&ifs, letters, mesh, (hull.min(), hull.max()));
        let list = means.of(mesh);
        assert_eq!(list.len(), means.count());
        list
    }

    /// Two or three maps that turn, shear, mirror and flatten, and meshes of any size.
    fn any_shape() -> impl Strategy<Value = Vec<Affine2>> {
        let map = proptest::array::uniform6(-0.55..0.55_f64).prop_map(Affine2::from_row);
        proptest::collection::vec(map, 2..4).prop_filter("a shape", |maps| Ifs::new(maps.clone()).is_ok())
    }

    fn any_mesh() -> impl Strategy<Value = Mesh> {
        (2..=7_usize, 2..=7_usize).prop_flat_map(|(columns, rows)| {
            proptest::collection::vec((-1.0..1.0_f64, -1.0..1.0_f64), columns * rows).prop_map(move |list| {
                let list = list.into_iter().map(DVec2::from).collect();
                Mesh::new(DVec2::new(-1.5, -2.0), DVec2::new(2.0, 1.0), columns, rows, list).unwrap()
            })
        })
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(frond_testing::cases(100)))]

        #[test]
        fn the_mean_of_a_piece_is_that_of_its_pieces(maps in any_shape(), mesh in any_mesh(), letters in 0..5_usize) {
            let (coarse, fine) = (means(&maps, letters, &mesh), means(&maps, letters + 1, &mesh));
            let ifs = Ifs::new(maps).unwrap();
            for (mean, parts) in coarse.iter().zip(fine.chunks_exact(ifs.len())) {
                let wanted: DVec2 = parts.iter().zip(ifs.probabilities()).map(|(part, p)| *part * *p).sum();
                prop_assert!(mean.distance(wanted) < 1e-10 * (1.0 + wanted.length()), "{mean} {wanted}");
            }
        }

        #[test]
        fn the_displacement_behind_a_map_is_a_polynomial(
            mesh in any_mesh(), row in proptest::array::uniform6(-1.0..1.0_f64), x in -0.7..0.7_f64, y in -0.7..0.7_f64,
        ) {
            let (map, degree) = (Affine2::from_row(row), mesh.columns() + mesh.rows() - 2);
            let mut terms = vec![DVec2::NAN; monomials(degree)];
            expand(&mesh, &map, &mut terms);
            let pairs = (0..=degree).flat_map(|n| (0..=n).map(move |j| ((n - j) as i32, j as i32)));
            let found: DVec2 = pairs.zip(&terms).map(|((i, j), &term)| term * x.powi(i) * y.powi(j)).sum();
            let wanted = mesh.at(map.apply(DVec2::new(x, y)));
            prop_assert!(found.distance(wanted) < 1e-11 * (1.0 + wanted.length()), "{found} {wanted}");
        }
    }

    #[test]
    fn the_largest_mesh_on_small_and_large_shapes() {
        for scale in [1e-9, 1.0, 1e9] {
            let corners = [DVec2::ZERO, DVec2::X, DVec2::Y].map(|corner| corner * scale);
            let maps = corners.map(|c| Affine2::similitude(0.5, 0.0, 0.5 * c));
            let list =
                (0..256).map(|i| DVec2::new(f64::from(i * 7 % 16), f64::from(i * 5 % 16)) / 16.0).collect();
            let mesh = Mesh::new(DVec2::ZERO, DVec2::splat(scale), 16, 16, list).unwrap();
            let found = means(&maps, 1, &mesh);
            // By the points of 3^9 pieces, each piece's middle for all of it.
            let count = 3_usize.pow(8);
            let fine = words(&maps, 9);
            let middle = DVec2::splat(scale / 3.0);
            for (mean, words) in found.iter().zip(fine.chunks_exact(count)) {
                let wanted =
                    words.iter().map(|word| mesh.at(word.apply(middle))).sum::<DVec2>() / count as f64;
                assert!(mean.distance(wanted) < 1e-5, "{scale}: {mean} {wanted}");
            }
        }
    }
}
