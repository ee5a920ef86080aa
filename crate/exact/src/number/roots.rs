//! The complex roots of a polynomial, each in a box of its own.
//!
//! Roots are approximated together (Aberth 1973). Then discs are proved around them (Smith 1970): where `z_i` are any n
//! different points, each component of the union of the discs around `z_i` with radius
//! `n |p(z_i)| / |a_n prod_{j != i} (z_i - z_j)|` contains as many roots as it has discs. Disjoint discs are one
//! root each.

use std::cmp::Ordering;

use crate::error::ExactError;
use crate::number::interval::Interval;
use crate::number::polynomial::Polynomial;
use crate::number::rational::Rational;

/// A complex number in a box.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ComplexInterval {
    /// The real part.
    pub re: Interval,
    /// The imaginary part.
    pub im: Interval,
}

impl ComplexInterval {
    /// A real number.
    #[must_use]
    pub const fn real(re: Interval) -> Self {
        Self { re, im: Interval::ZERO }
    }

    /// The sum.
    #[must_use]
    pub fn plus(self, other: Self) -> Self {
        Self { re: self.re + other.re, im: self.im + other.im }
    }

    /// The product.
    #[must_use]
    pub fn times(self, other: Self) -> Self {
        Self { re: self.re * other.re - self.im * other.im, im: self.re * other.im + self.im * other.re }
    }

    /// The conjugate.
    #[must_use]
    pub fn conjugate(self) -> Self {
        Self { re: self.re, im: -self.im }
    }

    /// The square of the absolute value.
    #[must_use]
    pub fn square_size(self) -> Interval {
        self.re.square() + self.im.square()
    }

    /// Whether two boxes have a point in common.
    #[must_use]
    pub fn meets(self, other: Self) -> bool {
        self.re.meets(other.re) && self.im.meets(other.im)
    }
}

/// A root of a polynomial.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Root {
    /// Where it is. The box contains no other root.
    pub place: ComplexInterval,
    /// Whether it is a real number, which is proved.
    pub is_real: bool,
}

const MOST_STEPS: usize = 200;

/// All roots of a squarefree polynomial: real ones first, from left to right, then others.
pub(crate) fn roots(polynomial: &Polynomial) -> Result<Vec<Root>, ExactError> {
    let n = polynomial.degree();
    if n == 0 {
        return Err(ExactError::NoRoot);
    }
    let monic = polynomial.monic();
    if monic.coefficients().iter().any(|c| !c.to_f64().is_finite()) {
        return Err(ExactError::RootsTooNear);
    }
    let centres = symmetric(approximations(&monic));
    let coefficients: Vec<Interval> = monic.coefficients().iter().map(Rational::enclosure).collect();
    let mut found = Vec::with_capacity(n);
    for (i, &(x, y)) in centres.iter().enumerate() {
        let z = point(x, y);
        let value = around(&coefficients, z).square_size().sqrt();
        let mut spread = Interval::ONE;
        for (j, &(u, v)) in centres.iter().enumerate() {
            if j != i {
                spread = spread * z.plus(point(-u, -v)).square_size().sqrt();
            }
        }
        let radius = (Interval::point(n as f64) * value / spread).upper();
        if !radius.is_finite() {
            return Err(ExactError::RootsTooNear);
        }
        let grown = Interval::new(-radius, radius);
        found.push(Root { place: ComplexInterval { re: z.re + grown, im: z.im + grown }, is_real: y == 0.0 });
    }
    for (i, a) in found.iter().enumerate() {
        // A disc around a point of the real axis has the conjugate of its one root in it, which is that root.
        let crosses = !a.is_real && a.place.im.contains(0.0);
        if crosses || found[..i].iter().any(|b| a.place.meets(b.place)) {
            return Err(ExactError::RootsTooNear);
        }
    }
    for root in found.iter_mut().filter(|root| root.is_real) {
        root.place = ComplexInterval::real(narrowed(&monic, root.place.re)?);
    }
    let middle = |root: &Root| (root.place.re.middle(), root.place.im.middle());
    found.sort_by(|a, b| {
        let ((ax, ay), (bx, by)) = (middle(a), middle(b));
        b.is_real.cmp(&a.is_real).then(ax.total_cmp(&bx)).then(ay.total_cmp(&by))
    });
    Ok(found)
}

const fn point(x: f64, y: f64) -> ComplexInterval {
    ComplexInterval { re: Interval::point(x), im: Interval::point(y) }
}

fn around(coefficients: &[Interval], z: ComplexInterval) -> ComplexInterval {
    let zero = ComplexInterval::real(Interval::ZERO);
    coefficients.iter().rev().fold(zero, |sum, &c| sum.times(z).plus(ComplexInterval::real(c)))
}

/// The one root in an interval of the real axis between doubles next to each other, by halving.
fn narrowed(polynomial: &Polynomial, place: Interval) -> Result<Interval, ExactError> {
    let sign = |x: f64| Rational::from_f64(x).map(|x| polynomial.at(&x).sign());
    let (mut lower, mut upper) = (place.lower(), place.upper());
    let (Some(first), Some(last)) = (sign(lower), sign(upper)) else { return Err(ExactError::RootsTooNear) };
    if first == Ordering::Equal {
        return Ok(Interval::point(lower));
    }
    if last == Ordering::Equal {
        return Ok(Interval::point(upper));
    }
    if first == last {
        return Err(ExactError::RootsTooNear);
    }
    loop {
        let middle = lower.midpoint(upper);
        if middle <= lower || middle >= upper {
            return Ok(Interval::new(lower, upper));
        }
        match sign(middle) {
            Some(Ordering::Equal) => return Ok(Interval::point(middle)),
            found if found == Some(first) => lower = middle,
            _ => upper = middle,
        }
    }
}

type Point = (f64, f64);

fn times(a: Point, b: Point) -> Point {
    (a.0 * b.0 - a.1 * b.1, a.0 * b.1 + a.1 * b.0)
}

fn over(a: Point, b: Point) -> Point {
    let size = b.0 * b.0 + b.1 * b.1;
    ((a.0 * b.0 + a.1 * b.1) / size, (a.1 * b.0 - a.0 * b.1) / size)
}

fn approximations(monic: &Polynomial) -> Vec<Point> {
    let c: Vec<f64> = monic.coefficients().iter().map(Rational::to_f64).collect();
    let n = c.len() - 1;
    // All roots are within this bound of Fujiwara; the start is a circle of a typical size among them.
    let size = (0..n).map(|k| 2.0 * c[k].abs().powf(1.0 / (n - k) as f64)).fold(0.0, f64::max);
    let typical = c[0].abs().powf(1.0 / n as f64).clamp(size * 1e-3, size);
    let mut z: Vec<Point> = (0..n)
        .map(|k| {
            let angle = 0.4 + std::f64::consts::TAU * k as f64 / n as f64;
            (typical * angle.cos(), typical * angle.sin())
        })
        .collect();
    for _ in 0..MOST_STEPS {
        let mut largest: f64 = 0.0;
        for i in 0..n {
            let (mut value, mut slope) = ((0.0, 0.0), (0.0, 0.0));
            for &c in c.iter().rev() {
                let next = times(slope, z[i]);
                slope = (next.0 + value.0, next.1 + value.1);
                let next = times(value, z[i]);
                value = (next.0 + c, next.1);
            }
            if value == (0.0, 0.0) {
                continue;
            }
            let newton = over(value, slope);
            let mut push = (0.0, 0.0);
            for j in (0..n).filter(|&j| j != i) {
                let away = over((1.0, 0.0), (z[i].0 - z[j].0, z[i].1 - z[j].1));
                push = (push.0 + away.0, push.1 + away.1);
            }
            let pushed = times(newton, push);
            let step = over(newton, (1.0 - pushed.0, -pushed.1));
            if step.0.is_finite() && step.1.is_finite() {
                z[i] = (z[i].0 - step.0, z[i].1 - step.1);
                largest = largest.max(step.0.hypot(step.1) / z[i].0.hypot(z[i].1).max(1e-300));
            }
        }
        if largest < 1e-16 {
            break;
        }
    }
    z
}

/// Those next to the real axis on it, so that real roots are seen to be real.
fn symmetric(mut z: Vec<Point>) -> Vec<Point> {
    for i in 0..z.len() {
        let to_own = 2.0 * z[i].1.abs();
        let others = (0..z.len()).filter(|&j| j != i);
        let mirrored = others.map(|j| (z[i].0 - z[j].0).hypot(z[i].1 + z[j].1)).fold(f64::INFINITY, f64::min);
        if to_own < mirrored {
            z[i].1 = 0.0;
        }
    }
    z
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(coefficients: &[i64]) -> Result<Vec<Root>, ExactError> {
        roots(&Polynomial::new(coefficients.iter().map(|&c| Rational::whole(c)).collect()))
    }

    #[test]
    fn real_roots_are_told_from_others() {
        // Tribonacci: 1.839286755214161 (OEIS A058265), and a pair of complex ones of size 0.7373527.
        let found = of(&[-1, -1, -1, 1]).unwrap();
        assert!(found[0].is_real && !found[1].is_real && !found[2].is_real);
        assert!((found[0].place.re.middle() - 1.839_286_755_214_161).abs() < 1e-15);
        assert!(found[0].place.re.width() < 1e-15);
        assert!((found[2].place.square_size().sqrt().middle() - 0.737_352_705_760_327).abs() < 1e-13);
        assert!(found[2].place.im.width() < 1e-12);
        assert!(
            of(&[-1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1]).unwrap().iter().filter(|root| root.is_real).count()
                == 2
        );
        assert_eq!(of(&[3]), Err(ExactError::NoRoot));
    }

    #[test]
    fn roots_that_doubles_do_not_tell_apart_are_refused() {
        // (x^2 - 2)^2 is one root twice.
        assert_eq!(of(&[4, 0, -4, 0, 1]), Err(ExactError::RootsTooNear));
    }
}
