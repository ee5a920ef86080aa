//! Polar decomposition in space.

use glam::{DMat3, DVec3};

/// The polar decomposition `M = Q S` of a 3 x 3 matrix, `Q` orthogonal and `S` symmetric with no
/// negative eigenvalue (Burch & Hart 1997, eqs 2 and 3).
///
/// Where `M` is singular, `Q` is completed to a rotation: of all orthogonal matrices that fit, the one
/// with determinant 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Polar3 {
    /// The orthogonal factor `Q`; its determinant is -1 if the map reflects.
    pub orthogonal: DMat3,
    /// The stretch `S`.
    pub stretch: DMat3,
}

impl Polar3 {
    /// The decomposition from the eigenvectors of `M^T M`.
    #[must_use]
    pub fn of(m: DMat3) -> Self {
        // Well-conditioned matrices go through the iteration, which loses nothing to squaring.
        if let Some(polar) = Self::by_iteration(m) {
            return polar;
        }
        Self::by_eigenvectors(m)
    }

    /// The decomposition by averaging with the inverse transpose (Burch & Hart 1997, eq 2). `None`
    /// where the matrix is singular or close to it.
    #[must_use]
    pub fn by_iteration(m: DMat3) -> Option<Self> {
        let size = largest(m);
        if !m.is_finite() || size == 0.0 {
            return None;
        }
        let mut q = m * (1.0 / size);
        if q.determinant().abs() < 1e-12 {
            return None;
        }
        for _ in 0..100 {
            let next = (q + q.inverse().transpose()) * 0.5;
            let change = largest(next - q);
            q = next;
            if change < 1e-15 {
                break;
            }
        }
        Some(Self { orthogonal: q, stretch: symmetric(q.transpose() * m) })
    }

    /// The decomposition from the eigenvectors of `M^T M`, by Jacobi's rotations: `S` is its square
    /// root. It takes singular matrices as well.
    #[must_use]
    pub fn by_eigenvectors(m: DMat3) -> Self {
        let (values, vectors) = jacobi(m.transpose() * m);
        let order = {
            let mut order = [0, 1, 2];
            order.sort_by(|&i, &j| values[j].total_cmp(&values[i]));
            order
        };
        let v = order.map(|i| vectors.col(i));
        // Images of the axes of the ellipsoid: lengths are the singular values.
        let images = v.map(|axis| m * axis);
        let scale = images[0].length();
        if scale == 0.0 {
            return Self { orthogonal: DMat3::IDENTITY, stretch: DMat3::ZERO };
        }
        let tiny = 1e-12 * scale;
        let handed = v[0].cross(v[1]).dot(v[2]).signum();
        let u0 = images[0] / scale;
        let second = images[1] - u0 * u0.dot(images[1]);
        let u1 = if second.length() > tiny { second.normalize() } else { u0.any_orthonormal_vector() };
        let across = u0.cross(u1) * handed;
        let u2 = if images[2].length() > tiny && images[2].dot(across) < 0.0 { -across } else { across };
        let q = DMat3::from_cols(u0, u1, u2) * DMat3::from_cols(v[0], v[1], v[2]).transpose();
        Self { orthogonal: q, stretch: symmetric(q.transpose() * m) }
    }
}

fn largest(m: DMat3) -> f64 {
    m.to_cols_array().into_iter().fold(0.0, |most, x| x.abs().max(most))
}

fn symmetric(m: DMat3) -> DMat3 {
    (m + m.transpose()) * 0.5
}

/// Eigenvalues and eigenvectors (columns) of a symmetric matrix.
pub(crate) fn jacobi(mut a: DMat3) -> ([f64; 3], DMat3) {
    let mut vectors = DMat3::IDENTITY;
    for _ in 0..32 {
        let off = a.y_axis.x.abs() + a.z_axis.x.abs() + a.z_axis.y.abs();
        if off <= 1e-300_f64.max(1e-18 * largest(a)) {
            break;
        }
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            let apq = a.col(q)[p];
            if apq == 0.0 {
                continue;
            }
            let tau = (a.col(q)[q] - a.col(p)[p]) / (2.0 * apq);
            let t = tau.signum() / (tau.abs() + tau.hypot(1.0));
            let c = 1.0 / t.hypot(1.0);
            let s = t * c;
            let mut turn = DMat3::IDENTITY;
            turn.col_mut(p)[p] = c;
            turn.col_mut(q)[q] = c;
            turn.col_mut(q)[p] = s;
            turn.col_mut(p)[q] = -s;
            a = turn.transpose() * a * turn;
            vectors *= turn;
        }
    }
    ([a.x_axis.x, a.y_axis.y, a.z_axis.z], orthonormal(vectors))
}

fn orthonormal(m: DMat3) -> DMat3 {
    let x = m.x_axis.normalize();
    let y = (m.y_axis - x * x.dot(m.y_axis)).normalize();
    let z: DVec3 = x.cross(y) * x.cross(y).dot(m.z_axis).signum();
    DMat3::from_cols(x, y, z)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn entry() -> impl Strategy<Value = f64> {
        prop_oneof![3 => -2.0..2.0_f64, 1 => Just(0.0), 1 => Just(1.0)]
    }

    proptest! {
        #[test]
        fn the_factors_are_what_they_claim(m in proptest::array::uniform9(entry())) {
            let m = DMat3::from_cols_array(&m);
            let p = Polar3::of(m);
            prop_assert!(largest(p.orthogonal.transpose() * p.orthogonal - DMat3::IDENTITY) < 1e-12);
            prop_assert!(largest(p.orthogonal * p.stretch - m) < 1e-9, "{:?}", p.orthogonal * p.stretch - m);
        }

        #[test]
        fn the_iteration_agrees_with_the_eigenvectors(m in proptest::array::uniform9(-1.0..1.0_f64)) {
            let m = DMat3::from_cols_array(&m);
            prop_assume!(m.determinant().abs() > 0.1);
            let (a, b) = (Polar3::by_iteration(m).unwrap(), Polar3::by_eigenvectors(m));
            prop_assert!(largest(a.orthogonal - b.orthogonal) < 1e-12);
            prop_assert!(largest(a.stretch - b.stretch) < 1e-12);
        }
    }

    #[test]
    fn singular_matrices_keep_a_rotation() {
        for m in [
            DMat3::ZERO,
            DMat3::from_diagonal(DVec3::new(2.0, 0.0, 0.0)),
            DMat3::from_diagonal(DVec3::new(2.0, 3.0, 0.0)),
        ] {
            let p = Polar3::of(m);
            assert!((p.orthogonal.determinant() - 1.0).abs() < 1e-12);
            assert!(largest(p.orthogonal * p.stretch - m) < 1e-12);
        }
    }
}
