//! Sine and cosine.

/// Sine and cosine, exact at whole quarter turns as they are written in floating point.
pub(crate) fn sin_cos(angle: f64) -> (f64, f64) {
    let quarters = angle / std::f64::consts::FRAC_PI_2;
    if quarters.fract() == 0.0 && quarters.abs() < 1e15 {
        return [(0.0, 1.0), (1.0, 0.0), (0.0, -1.0), (-1.0, 0.0)][quarters.rem_euclid(4.0) as usize];
    }
    angle.sin_cos()
}
