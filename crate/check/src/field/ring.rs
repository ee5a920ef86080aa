//! Whole numbers and one number more: `Z[y] / (q)`, where the highest coefficient of `q` is 1, and a real root of `q`.
//!
//! Nothing here asks whether `q` has factors. To put the root in for `y` takes sums to sums and products to products,
//! so that elements that are equal are equal numbers. Others may be equal numbers as well, if `q` has factors: nothing
//! is concluded from that they differ. That a number is positive or negative is read off from an interval around it.

use std::cmp::Ordering;

use num_bigint::{BigInt, Sign};

use crate::work::{digits, product};

/// The coefficients of `1, y, y^2 ..`, as many as the degree of `q`.
pub(crate) type Element = Vec<BigInt>;

/// So often the interval around the root is halved.
const HALVINGS: u64 = 256;

pub(crate) struct Ring {
    /// The coefficients of `q` but for the highest, which is 1.
    rest: Vec<BigInt>,
    /// The root is between `low / under` and `high / under`.
    root: Interval,
    under: BigInt,
    /// Binary digits of the ends of the interval, once it is narrow.
    ends: u64,
    /// By so many binary digits a product is longer than its factors together.
    pub growth: u64,
}

/// Numbers from `low` to `high`.
#[derive(Clone)]
struct Interval {
    low: BigInt,
    high: BigInt,
}

impl Interval {
    fn of(x: BigInt) -> Self {
        Self { low: x.clone(), high: x }
    }

    fn times(&self, other: &Self) -> Self {
        let [a, b] = [&self.low, &self.high].map(|x| [x * &other.low, x * &other.high]);
        let all = [&a[0], &a[1], &b[0], &b[1]];
        let (low, high) = (all.iter().min().copied(), all.iter().max().copied());
        Self { low: low.cloned().unwrap_or_default(), high: high.cloned().unwrap_or_default() }
    }

    /// The sign of all numbers in it, if they have one.
    fn sign(&self) -> Option<Ordering> {
        let [low, high] = [&self.low, &self.high].map(|x| x.cmp(&BigInt::ZERO));
        (low == high).then_some(low)
    }
}

impl Ring {
    /// From the coefficients of `q` but for the highest, and the ends of the interval around its root over one positive
    /// number.
    pub fn new(rest: Vec<BigInt>, [low, high]: [BigInt; 2], under: BigInt) -> Self {
        let count = rest.len() as u64;
        let growth = u64::from(64 - count.leading_zeros()) + (count - 1) * digits(&rest);
        let ends = digits([&low, &high, &under]) + HALVINGS;
        Self { rest, root: Interval { low, high }, under, ends, growth }
    }

    pub fn degree(&self) -> usize {
        self.rest.len()
    }

    pub fn whole(&self, x: BigInt) -> Element {
        let mut element = vec![BigInt::ZERO; self.degree()];
        element[0] = x;
        element
    }

    /// What a product takes, of factors with coefficients of so many binary digits.
    pub fn cost_product(&self, a: u64, b: u64) -> u64 {
        let square = (self.degree() * self.degree()) as u64;
        let reduce = if square > 1 { product(a + b + self.growth, digits(&self.rest)) } else { 0 };
        square.saturating_mul(product(a, b).saturating_add(reduce))
    }

    /// Before it is reduced, a coefficient is a sum of as many products as the degree, at the most. Each step of the
    /// reduction adds to it a multiple of another by a coefficient of `q`.
    pub fn product(&self, a: &Element, b: &Element) -> Element {
        let degree = self.degree();
        let mut long = vec![BigInt::ZERO; 2 * degree - 1];
        for (i, x) in a.iter().enumerate().filter(|(_, x)| x.sign() != Sign::NoSign) {
            for (j, y) in b.iter().enumerate() {
                long[i + j] += x * y;
            }
        }
        for top in (degree..long.len()).rev() {
            let factor = std::mem::take(&mut long[top]);
            for (k, q) in self.rest.iter().enumerate() {
                long[top - degree + k] -= &factor * q;
            }
        }
        long.truncate(degree);
        long
    }

    /// What [`Self::narrow`] takes. It is asked for before.
    pub fn cost_narrow(&self) -> u64 {
        let degree = self.degree() as u64;
        let value = degree * self.ends + digits(&self.rest) + degree;
        (HALVINGS + 8).saturating_mul((degree + 1).saturating_mul(3 * product(value, self.ends)))
    }

    /// Whether there is just one root in the interval; makes it narrow.
    ///
    /// `q` changes its sign from the one end to the other, so that it has a root between them. Its derivative is not 0
    /// anywhere on the interval, so that it has but one.
    pub fn narrow(&mut self) -> bool {
        let below = self.value(&self.root.low);
        let above = self.value(&self.root.high);
        if self.root.low >= self.root.high || below.sign() == Sign::NoSign || above.sign() != -below.sign() {
            return false;
        }
        let highest = BigInt::from(self.degree());
        let slope =
            self.rest.iter().enumerate().skip(1).map(|(k, q)| q * k).chain([highest]).collect::<Vec<_>>();
        if !matches!(self.enclose(&slope).sign(), Some(Ordering::Less | Ordering::Greater)) {
            return false;
        }
        for _ in 0..HALVINGS {
            let middle = &self.root.low + &self.root.high;
            let Interval { low, high } = &mut self.root;
            (*low, *high) = (&*low << 1, &*high << 1);
            self.under <<= 1;
            let value = self.value(&middle);
            if value.sign() == Sign::NoSign {
                self.root = Interval::of(middle);
                break;
            }
            *(if value.sign() == below.sign() { &mut self.root.low } else { &mut self.root.high }) = middle;
        }
        true
    }

    /// `q` at a fraction over `under`, times a positive number.
    fn value(&self, over: &BigInt) -> BigInt {
        let (mut sum, mut power) = (BigInt::from(1), BigInt::from(1));
        for coefficient in self.rest.iter().rev() {
            power *= &self.under;
            sum = sum * over + coefficient * &power;
        }
        sum
    }

    /// Around what a polynomial is for any number of the interval, times a positive number.
    fn enclose(&self, coefficients: &[BigInt]) -> Interval {
        let (mut sum, mut power) = (Interval::of(BigInt::ZERO), BigInt::from(1));
        for (k, coefficient) in coefficients.iter().rev().enumerate() {
            if k > 0 {
                power *= &self.under;
                sum = sum.times(&self.root);
            }
            let more = coefficient * &power;
            sum = Interval { low: sum.low + &more, high: sum.high + more };
        }
        sum
    }

    /// What [`Self::sign`] takes, of an element with so many binary digits.
    pub fn cost_sign(&self, element: u64) -> u64 {
        let degree = self.degree() as u64;
        let value = element + degree * (self.ends + 1);
        degree.saturating_mul(6 * product(value, self.ends))
    }

    /// Whether an element is a number below, at or above 0. `None` where the interval is too wide to tell.
    pub fn sign(&self, element: &Element) -> Option<Ordering> {
        if is_zero(element) { Some(Ordering::Equal) } else { self.enclose(element).sign() }
    }
}

pub(crate) fn is_zero(element: &Element) -> bool {
    element.iter().all(|x| x.sign() == Sign::NoSign)
}

pub(crate) fn plus(a: &Element, b: &Element) -> Element {
    a.iter().zip(b).map(|(a, b)| a + b).collect()
}

pub(crate) fn minus(a: &Element, b: &Element) -> Element {
    a.iter().zip(b).map(|(a, b)| a - b).collect()
}

pub(crate) fn times(a: &Element, factor: &BigInt) -> Element {
    a.iter().map(|a| a * factor).collect()
}
