//! Four numbers at once.
//!
//! Left to itself the compiler makes vector instructions of some loops and not of others; `wide` says which.

use std::ops::{Add, Div, Mul, Neg, Sub};

use glam::DVec2;
use wide::f64x4;

/// Four numbers.
#[derive(Clone, Copy, Debug)]
pub(crate) struct F64x4(f64x4);

/// Four vectors of the plane.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct DVec2x4 {
    pub x: F64x4,
    pub y: F64x4,
}

impl Default for F64x4 {
    /// Four zeros. Those of `wide`'s own are a call in WebAssembly, and took a fifth of the time of a locus.
    #[inline(always)]
    fn default() -> Self {
        Self(f64x4::ZERO)
    }
}

impl F64x4 {
    #[inline(always)]
    pub fn new(four: [f64; 4]) -> Self {
        Self(f64x4::new(four))
    }

    #[inline(always)]
    pub fn splat(x: f64) -> Self {
        Self(f64x4::splat(x))
    }

    #[inline(always)]
    pub fn to_array(self) -> [f64; 4] {
        self.0.to_array()
    }

    #[inline(always)]
    pub fn abs(self) -> Self {
        Self(self.0.abs())
    }

    #[inline(always)]
    pub fn sqrt(self) -> Self {
        Self(self.0.sqrt())
    }

    /// The lesser of each two; the second where one is NaN.
    #[inline(always)]
    pub fn min(self, other: Self) -> Self {
        match KIND {
            Kind::SecondOfNan => Self(self.0.fast_min(other.0)),
            Kind::FirstOfNan => Self(other.0.fast_min(self.0)),
            Kind::Other => self.choose_less(other, self, other),
        }
    }

    /// The greater of each two; the second where one is NaN.
    #[inline(always)]
    pub fn max(self, other: Self) -> Self {
        match KIND {
            Kind::SecondOfNan => Self(self.0.fast_max(other.0)),
            Kind::FirstOfNan => Self(other.0.fast_max(self.0)),
            Kind::Other => other.choose_less(self, self, other),
        }
    }

    /// `yes` where `self < other`, else `no`.
    #[inline(always)]
    pub fn choose_less(self, other: Self, yes: Self, no: Self) -> Self {
        Self(self.0.simd_lt(other.0).bitselect(yes.0, no.0))
    }

    /// Whether all are greater than 0.
    #[inline(always)]
    pub fn all_positive(self) -> bool {
        f64x4::ZERO.simd_lt(self.0).all()
    }
}

/// What a machine's own least and greatest of two numbers are where one is NaN.
enum Kind {
    SecondOfNan,
    FirstOfNan,
    Other,
}

const KIND: Kind = if cfg!(target_arch = "x86_64") {
    Kind::SecondOfNan
} else if cfg!(target_arch = "wasm32") {
    Kind::FirstOfNan
} else {
    Kind::Other
};

macro_rules! lanewise {
    ($($trait:ident $f:ident $op:tt),*) => {$(
        impl $trait for F64x4 {
            type Output = Self;
            #[inline(always)]
            fn $f(self, other: Self) -> Self {
                Self(self.0 $op other.0)
            }
        }
    )*};
}
lanewise!(Add add +, Sub sub -, Mul mul *, Div div /);

impl Neg for F64x4 {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl DVec2x4 {
    #[inline(always)]
    pub fn splat(p: DVec2) -> Self {
        Self { x: F64x4::splat(p.x), y: F64x4::splat(p.y) }
    }

    /// The vectors with these coordinates.
    #[inline(always)]
    pub fn new(four: [DVec2; 4]) -> Self {
        Self { x: F64x4::new(four.map(|p| p.x)), y: F64x4::new(four.map(|p| p.y)) }
    }

    #[inline(always)]
    pub fn dot(self, other: Self) -> F64x4 {
        self.x * other.x + self.y * other.y
    }

    /// Vector `k`.
    #[inline(always)]
    pub fn at(self, k: usize) -> DVec2 {
        DVec2::new(self.x.to_array()[k], self.y.to_array()[k])
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
