//! A field that has two fields in it.

use std::sync::Arc;

use crate::error::ExactError;
use crate::number::factor::LARGEST_DEGREE;
use crate::number::field::{Element, Field, LARGEST_FIELD};
use crate::number::interval::Interval;
use crate::number::matrix::Echelon;
use crate::number::polynomial::Polynomial;
use crate::number::rational::Rational;
use crate::number::roots::ComplexInterval;

/// A field, and where the generators of two others are in it.
pub(crate) struct Compositum {
    pub field: Arc<Field>,
    pub first: Element,
    pub second: Element,
}

/// Factors of the second generator that are tried.
const FACTORS: [i64; 6] = [1, -1, 2, -2, 3, -3];

/// The least field with both in it, where its degree is at most [`LARGEST_FIELD`].
///
/// The algebra with both generators as independent ones is a sum of fields. A combination of the two generates it;
/// one factor of its polynomial has the combination of the two roots that are meant.
pub(crate) fn compositum(a: &Arc<Field>, b: &Arc<Field>) -> Result<Compositum, ExactError> {
    if b.degree() == 1 || a == b {
        let second = if b.degree() == 1 { a.rational(b.generator().0[0].clone()) } else { a.generator() };
        return Ok(Compositum { field: a.clone(), first: a.generator(), second });
    }
    if a.degree() == 1 {
        let first = b.rational(a.generator().0[0].clone());
        return Ok(Compositum { field: b.clone(), first, second: b.generator() });
    }
    let size = a.degree() * b.degree();
    if size > LARGEST_DEGREE {
        return Err(ExactError::DegreeTooLarge { degree: size, most: LARGEST_FIELD });
    }
    for k in FACTORS {
        let factor = Rational::whole(k);
        let (mut space, mut power) = (Echelon::default(), unit(0, size));
        let factors = loop {
            if let Some(factors) = space.insert(power.clone()) {
                break factors;
            }
            power = times_combination(a, b, &factor, &power);
        };
        if factors.len() < size {
            continue;
        }
        let mut coefficients: Vec<Rational> = factors.iter().map(|factor| -factor).collect();
        coefficients.push(Rational::ONE);
        let place = combined(a.root().place, b.root().place, k);
        let field = Field::of_root_up_to(&Polynomial::new(coefficients), place, LARGEST_FIELD)?;
        let Some(first) = space.express(unit(b.degree(), size)) else { continue };
        let Some(second) = space.express(unit(1, size)) else { continue };
        let (first, second) = (field.element(&first), field.element(&second));
        return Ok(Compositum { field: Arc::new(field), first, second });
    }
    Err(ExactError::FactoringTooHard)
}

fn combined(a: ComplexInterval, b: ComplexInterval, k: i64) -> ComplexInterval {
    let k = Interval::of_i64(k);
    a.plus(ComplexInterval { re: k * b.re, im: k * b.im })
}

fn unit(k: usize, size: usize) -> Vec<Rational> {
    (0..size).map(|j| Rational::whole(i64::from(j == k))).collect()
}

/// x plus k times y, times an element of the algebra; `x^i y^j` is at place `i m + j`, where m is the degree of y.
fn times_combination(a: &Field, b: &Field, k: &Rational, element: &[Rational]) -> Vec<Rational> {
    let (n, m) = (a.degree(), b.degree());
    let (p, q) = (a.monic().coefficients(), b.monic().coefficients());
    let mut product = vec![Rational::ZERO; n * m];
    for i in 0..n {
        for j in 0..m {
            let c = &element[i * m + j];
            if c.is_zero() {
                continue;
            }
            let mut add = |place: usize, value: &Rational| product[place] = &product[place] + value;
            if i + 1 < n {
                add((i + 1) * m + j, c);
            } else {
                (0..n).for_each(|t| add(t * m + j, &-&(c * &p[t])));
            }
            let scaled = c * k;
            if j + 1 < m {
                add(i * m + j + 1, &scaled);
            } else {
                (0..m).for_each(|t| add(i * m + t, &-&(&scaled * &q[t])));
            }
        }
    }
    product
}
