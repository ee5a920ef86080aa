//! Bends against the formulas.

use frond_core::Affine2;
use frond_deform::{Bend, Continuity, Cursor, Field, Mesh, Place, Roughness, Settings, Spin};
use glam::DVec2;
use proptest::prelude::*;

fn fern() -> Vec<Affine2> {
    [
        [0.85, 0.04, -0.04, 0.85, 0.0, 1.6],
        [0.2, -0.26, 0.23, 0.22, 0.0, 1.6],
        [-0.15, 0.28, 0.26, 0.24, 0.0, 0.44],
        [0.0, 0.0, 0.0, 0.16, 0.0, 0.0],
    ]
    .map(Affine2::from_row)
    .to_vec()
}

fn mesh(list: &[(f64, f64)]) -> Mesh {
    let list = list.iter().map(|&pair| DVec2::from(pair)).collect();
    Mesh::new(DVec2::new(-3.0, 0.0), DVec2::new(3.0, 10.2), 4, 4, list).unwrap()
}

fn settings(kb: f64, ke: f64, delta: f64, spin: Spin, continuity: Continuity, superposed: bool) -> Settings {
    Settings { kb, ke, roughness: Roughness::Constant(delta), spin, continuity, superposed }
}

fn cursor(bend: &Bend, code: &[u8]) -> Cursor {
    code.iter().fold(bend.whole(), |cursor, &letter| bend.child(&cursor, usize::from(letter)))
}

proptest! {
    #[test]
    fn raw_terms_are_the_formula(
        code in proptest::collection::vec(0..4_u8, 6..12), kb in 0.0..6.0_f64, more in 0.0..6.0_f64, whole: bool,
        delta in 0.0..1.5_f64, list in proptest::collection::vec((-1.0..1.0_f64, -1.0..1.0_f64), 16), superposed: bool,
        spin in proptest::sample::select(vec![Spin::None, Spin::Orthogonal, Spin::Rotation, Spin::Scaled]),
    ) {
        let (kb, ke) = (kb, (kb + more).min(6.0));
        let (kb, ke) = if whole { (kb.floor(), ke.floor()) } else { (kb, ke) };
        let (maps, mesh) = (fern(), mesh(&list));
        let bend =
            Bend::new(&maps, mesh.clone(), settings(kb, ke, delta, spin, Continuity::Raw, superposed), None).unwrap();
        let place = Place { code: &code, tail: DVec2::new(0.1, 2.0) };
        let field = Field::new(&maps, &mesh, spin);
        let wanted = field.position(place)
            + if superposed { field.superposed_between(kb, ke, delta, place) } else { field.term_between(kb, ke, place) };
        let found = bend.point(&cursor(&bend, &code), place.tail);
        prop_assert!((found - wanted).length() < 1e-11, "{found} {wanted}");
    }
}
