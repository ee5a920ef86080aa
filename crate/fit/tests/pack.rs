//! Closed curves as bytes.

use frond_fit::{ArcCopy, ClosedCurve, Fitter, Outline, PackError, fidelity, maple_leaf};
use glam::DVec2;
use proptest::prelude::*;

/// A fit after some steps: knots and copies of all kinds.
fn fitted(numbers: usize) -> (Outline, ClosedCurve) {
    let outline = Outline::new(&maple_leaf(3)).unwrap();
    let mut fitter = Fitter::new(&outline, numbers).unwrap();
    while fitter.best().curve.copies() <= 3 && !fitter.is_done() {
        fitter.step();
    }
    let curve = fitter.best().curve.clone();
    assert!(curve.copies() > 3);
    (outline, curve)
}

#[test]
fn a_fit_of_260_numbers_is_as_good_in_half_a_kilobyte() {
    let (outline, curve) = fitted(260);
    let diagonal = outline.diagonal();
    let bytes = curve.to_bytes(2e-4 * diagonal).unwrap();
    assert!(bytes.len() <= 512, "{}", bytes.len());
    let back = ClosedCurve::from_bytes(&bytes).unwrap();
    assert!(back.is_sound());
    assert_eq!((back.knots.len(), back.copies()), (curve.knots.len(), curve.copies()));
    for (a, b) in curve.knots.iter().zip(&back.knots) {
        assert!(a.distance(*b) <= 2e-4 * diagonal);
    }
    for (a, b) in curve.edges.iter().zip(&back.edges) {
        let same = |a: &ArcCopy| ArcCopy { c: 0.0, ..*a };
        assert_eq!(a.as_ref().map(same), b.as_ref().map(same));
    }
    let rms = |curve: &ClosedCurve| fidelity(&outline, &curve.polyline(1e-4 * diagonal, 10)).rms;
    assert!(rms(&back) <= 1.05 * rms(&curve), "{} {}", rms(&back), rms(&curve));
    // On its grid it stays as it is.
    assert_eq!(ClosedCurve::from_bytes(&back.to_bytes(1e-9 * diagonal).unwrap()).unwrap().edges, back.edges);
}

#[test]
fn what_shrinks_only_just_is_sound_on_a_coarse_grid() {
    let knots: Vec<_> = (0..40).map(|i| DVec2::from_angle(f64::from(i) * 0.157) * 1e3).collect();
    let mut curve = ClosedCurve::polygon(knots);
    for index in 0..40 {
        let edge = Some(ArcCopy { from: (index + 7) % 40, span: 2, reversed: index % 2 == 0, c: 1.0 });
        curve.edges[index] = edge;
        let (linear, _) = curve.map(index).unwrap();
        let c = 0.899_999 / linear.x_axis.length();
        curve.edges[index] = edge.map(|copy| ArcCopy { c: if index % 3 == 0 { -c } else { c }, ..copy });
    }
    assert!(curve.is_sound());
    for precision in [1e-7, 0.5, 20.0, 60.0, f64::NAN, 0.0, f64::INFINITY, -1.0] {
        match curve.to_bytes(precision) {
            Ok(bytes) => assert!(ClosedCurve::from_bytes(&bytes).unwrap().is_sound(), "{precision}"),
            Err(error) => assert!(precision > 10.0, "{precision}: {error}"),
        }
    }
}

#[test]
fn bad_bytes_are_told() {
    let (outline, curve) = fitted(160);
    let bytes = curve.to_bytes(1e-3 * outline.diagonal()).unwrap();
    for many in 1..bytes.len() {
        assert!(ClosedCurve::from_bytes(&bytes[..many]).is_err(), "{many} bytes");
    }
    assert_eq!(ClosedCurve::from_bytes(&[]), Err(PackError::CutShort));
    let mut other = bytes.clone();
    other[0] = 9;
    assert_eq!(ClosedCurve::from_bytes(&other), Err(PackError::UnknownVersion));
    let mut large = curve;
    large.edges[0] = Some(ArcCopy { from: 0, span: 2, reversed: false, c: 1e9 });
    assert_eq!(large.to_bytes(0.1), Err(PackError::Unsound));
}

proptest! {
    #[test]
    fn any_bytes_are_a_sound_curve_or_an_error(mut bytes in prop::collection::vec(any::<u8>(), 0..200), places in prop::collection::vec((0_usize..200, any::<u8>()), 0..4)) {
        let (_, curve) = FITTED.with(Clone::clone);
        let mut good = curve.to_bytes(1e-3).unwrap();
        for (place, byte) in places {
            let count = good.len();
            good[place % count] ^= byte;
        }
        if let Some(first) = bytes.first_mut() {
            *first = 1;
        }
        for bytes in [bytes, good] {
            if let Ok(curve) = ClosedCurve::from_bytes(&bytes) {
                prop_assert!(curve.is_sound());
                prop_assert!(curve.polyline(1e-2, 3).iter().all(|p| p.is_finite()));
            }
        }
    }
}

thread_local! {
    static FITTED: (Outline, ClosedCurve) = fitted(160);
}
