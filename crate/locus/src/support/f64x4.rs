//! Four numbers at once: what a compiler turns into vector instructions.

use std::ops::{Add, Div, Mul, Neg, Sub};

use glam::DVec2;

/// Four numbers.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct F64x4(pub [f64; 4]);

/// Four vectors of the plane.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct DVec2x4 {
    pub x: F64x4,
    pub y: F64x4,
}

impl F64x4 {
    #[inline(always)]
    pub fn splat(x: f64) -> Self {
        Self([x; 4])
    }

    #[inline(always)]
    pub fn map(self, f: impl Fn(f64) -> f64) -> Self {
        Self([f(self.0[0]), f(self.0[1]), f(self.0[2]), f(self.0[3])])
    }

    #[inline(always)]
    pub fn zip(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        let ([a, b, c, d], [p, q, r, s]) = (self.0, other.0);
        Self([f(a, p), f(b, q), f(c, r), f(d, s)])
    }

    #[inline(always)]
    pub fn abs(self) -> Self {
        self.map(f64::abs)
    }

    #[inline(always)]
    pub fn sqrt(self) -> Self {
        self.map(f64::sqrt)
    }

    /// The lesser of each two; the second where one is NaN.
    #[inline(always)]
    pub fn min(self, other: Self) -> Self {
        self.zip(other, |a, b| if a < b { a } else { b })
    }

    /// The greater of each two; the second where one is NaN.
    #[inline(always)]
    pub fn max(self, other: Self) -> Self {
        self.zip(other, |a, b| if a > b { a } else { b })
    }

    /// `yes` where `self < other`, else `no`.
    #[inline(always)]
    pub fn choose_less(self, other: Self, yes: Self, no: Self) -> Self {
        let pick = |k: usize| if self.0[k] < other.0[k] { yes.0[k] } else { no.0[k] };
        Self([pick(0), pick(1), pick(2), pick(3)])
    }
}

macro_rules! lanewise {
    ($($trait:ident $f:ident $op:tt),*) => {$(
        impl $trait for F64x4 {
            type Output = Self;
            #[inline(always)]
            fn $f(self, other: Self) -> Self {
                self.zip(other, |a, b| a $op b)
            }
        }
    )*};
}
lanewise!(Add add +, Sub sub -, Mul mul *, Div div /);

impl Neg for F64x4 {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.map(|a| -a)
    }
}

impl DVec2x4 {
    #[inline(always)]
    pub fn splat(p: DVec2) -> Self {
        Self { x: F64x4::splat(p.x), y: F64x4::splat(p.y) }
    }

    #[inline(always)]
    pub fn dot(self, other: Self) -> F64x4 {
        self.x * other.x + self.y * other.y
    }

    /// Vector `k`.
    #[inline(always)]
    pub fn at(self, k: usize) -> DVec2 {
        DVec2::new(self.x.0[k], self.y.0[k])
    }
}

impl Sub for DVec2x4 {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self { x: self.x - other.x, y: self.y - other.y }
    }
}

impl Add for DVec2x4 {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self { x: self.x + other.x, y: self.y + other.y }
    }
}
