//! Why something is not computed exactly.

use thiserror::Error;

/// Why a number, a system or an answer cannot be had exactly.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[non_exhaustive]
pub enum ExactError {
    /// A division by zero.
    #[error("a division by zero")]
    DivisionByZero,
    /// The degree of a polynomial, or of a field that has all numbers in it, is too large.
    #[error("the degree is {degree}, and the most is {most}")]
    DegreeTooLarge {
        /// The degree that it has, or would have.
        degree: usize,
        /// The most that is computed with.
        most: usize,
    },
    /// There are too many ways to combine factors modulo a prime.
    #[error("the polynomial is too hard to factor")]
    FactoringTooHard,
    /// A constant has no root, and neither has zero.
    #[error("the polynomial is constant")]
    NoRoot,
    /// No factor, or more than one, has a root in the place that was given.
    #[error("the polynomial has {count} roots there, where one is needed")]
    NotOneRoot {
        /// How many there are.
        count: usize,
    },
    /// Doubles do not tell the roots of a polynomial apart.
    #[error("the roots of the polynomial are too near to each other")]
    RootsTooNear,
    /// The complex conjugate of a number is not in its field, or is not found there.
    #[error("the conjugate is not in the field")]
    NoConjugate,
    /// A text is no formula.
    #[error("not a formula, from byte {at}")]
    NotFormula {
        /// Where reading ended.
        at: usize,
    },
    /// A formula means a number that is not computed with exactly.
    #[error("not a number that is computed with exactly, at byte {at}")]
    NotExact {
        /// Where its part ends.
        at: usize,
    },
    /// A number is complex where it has to be real.
    #[error("a number is not real")]
    NotReal,
    /// A number is beyond all doubles, or its double is zero.
    #[error("no double stands for the number")]
    NoDouble,
    /// A number has the same nearest double as another one.
    #[error("the number has the same nearest double as another one of the list")]
    SameDouble,
    /// A list has another length than the dimension asks for, a state is none, or there is no map.
    #[error("the system is not well formed")]
    Malformed,
    /// There are more states or maps, or more dimensions, than are computed with.
    #[error("there are {count}, and the most is {most}")]
    TooMany {
        /// How many there are.
        count: usize,
        /// The most that are computed with.
        most: usize,
    },
    /// A map has no inverse.
    #[error("map {map} of state {state} has no inverse")]
    Singular {
        /// The state, from 0.
        state: usize,
        /// Its map, from 0.
        map: usize,
    },
    /// No norm was found in which all ways round through the system contract.
    #[error("the maps are not seen to contract")]
    NotContracting,
    /// A matrix does not keep the chosen subspace, or not as one number acts on it.
    #[error("map {map} of state {state} does not keep the subspace")]
    NotInvariant {
        /// The state, from 0.
        state: usize,
        /// Its map, from 0.
        map: usize,
    },
    /// The chosen eigenvalue has several eigenvectors.
    #[error("the eigenvalue is not simple")]
    NotSimple,
}

impl ExactError {
    /// A name that stays the same over versions, for programs.
    #[must_use]
    pub const fn code(&self) -> &'static str {
        match self {
            Self::DivisionByZero => "exact-division-by-zero",
            Self::DegreeTooLarge { .. } => "exact-degree-too-large",
            Self::FactoringTooHard => "exact-factoring-too-hard",
            Self::NoRoot => "exact-no-root",
            Self::NotOneRoot { .. } => "exact-not-one-root",
            Self::RootsTooNear => "exact-roots-too-near",
            Self::NoConjugate => "exact-no-conjugate",
            Self::NotFormula { .. } => "exact-not-formula",
            Self::NotExact { .. } => "exact-not-exact",
            Self::NotReal => "exact-not-real",
            Self::NoDouble => "exact-no-double",
            Self::SameDouble => "exact-same-double",
            Self::Malformed => "exact-malformed",
            Self::TooMany { .. } => "exact-too-many",
            Self::Singular { .. } => "exact-singular",
            Self::NotContracting => "exact-not-contracting",
            Self::NotInvariant { .. } => "exact-not-invariant",
            Self::NotSimple => "exact-not-simple",
        }
    }
}
