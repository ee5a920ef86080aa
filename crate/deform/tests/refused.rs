//! What cannot be bent.

mod common;

use common::{gasket, settings, unit_mesh};
use frond_core::Affine2;
use frond_deform::{Bend, BendError, Continuity, Roughness, Settings, Spin, Tint};

#[test]
fn what_cannot_be_bent_says_why() {
    let rest = unit_mesh(&[(0.0, 0.0); 16]);
    let good = settings(0.0, 4.0, 0.7, Spin::None, Continuity::Auto);
    let code =
        |settings: Settings| Bend::new(&gasket(), rest.clone(), settings, None).map_err(|e| e.code()).err();
    assert_eq!(code(good), None);
    for bad in [f64::NAN, f64::INFINITY, -1.0] {
        assert_eq!(code(Settings { kb: bad, ..good }), Some("bend-depth"));
        assert_eq!(code(Settings { ke: bad, ..good }), Some("bend-depth"));
        assert_eq!(code(Settings { roughness: Roughness::Constant(bad), ..good }), Some("bend-roughness"));
        assert_eq!(
            code(Settings { roughness: Roughness::Corners([0.5, bad, 0.5, 0.5]), ..good }),
            Some("bend-roughness")
        );
    }
    assert_eq!(code(Settings { kb: 4.5, ..good }), Some("bend-locality"));
    assert_eq!(code(Settings { roughness: Roughness::Constant(f64::MAX), ..good }), None);
    let shape = |maps: &[Affine2]| Bend::new(maps, rest.clone(), good, None).map_err(|e| e.code()).err();
    assert_eq!(shape(&[]), Some("no-maps"));
    assert_eq!(shape(&vec![gasket()[0]; 1_000_000]), Some("too-many-maps"));
    assert_eq!(shape(&[Affine2::IDENTITY]), Some("no-attractor"));
    assert_eq!(shape(&[Affine2::from_row([f64::NAN; 6])]), Some("not-finite"));
    let tint = |colours| Tint { colours, kb: 0.0, ke: 3.0, roughness: 1.0, superposed: true };
    let tinted = |tint| Bend::new(&gasket(), rest.clone(), good, Some(tint)).map_err(|e| e.code()).err();
    assert_eq!(tinted(tint(vec![[0.5; 3]; 16])), None);
    assert_eq!(tinted(tint(vec![[0.5; 3]; 15])), Some("bend-tint"));
    assert_eq!(tinted(tint(vec![[f64::NAN; 3]; 16])), Some("bend-tint"));
    assert_eq!(tinted(Tint { kb: 9.0, ..tint(vec![[0.5; 3]; 16]) }), Some("bend-locality"));
    let message = BendError::Locality { kb: 5.0, ke: 4.0 }.to_string();
    assert!(message.contains("Locality cannot exceed detail"), "{message}");
}
