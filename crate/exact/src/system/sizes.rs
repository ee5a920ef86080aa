//! Squares of absolute values as exact numbers.

use std::sync::Arc;

use crate::error::ExactError;
use crate::number::compositum::compositum;
use crate::number::field::{Element, Field};
use crate::number::polynomial::Polynomial;
use crate::number::value::Number;

/// A field that has the numbers of another and their conjugates.
pub(crate) struct Sizes {
    own: Arc<Field>,
    field: Arc<Field>,
    generator: Element,
    conjugate: Element,
}

impl Sizes {
    /// For the absolute values that numbers have where the generator stands for a root.
    pub fn new(own: &Arc<Field>, root: usize) -> Result<Self, ExactError> {
        let root = own.roots()[root];
        let of_place = |place| {
            let polynomial = Polynomial::of_whole(own.polynomial());
            Field::of_root_up_to(&polynomial, place, own.degree()).map(Arc::new)
        };
        let meant = if root == own.root() { own.clone() } else { of_place(root.place)? };
        if let Some(conjugate) = meant.conjugate(&meant.generator()) {
            return Ok(Self { own: own.clone(), generator: meant.generator(), field: meant, conjugate });
        }
        let both = compositum(&meant, &of_place(root.place.conjugate())?)?;
        Ok(Self { own: own.clone(), field: both.field, generator: both.first, conjugate: both.second })
    }

    /// The square of the absolute value of a number.
    pub fn square(&self, number: &Element) -> Number {
        let at = |generator| self.own.substitute(number.coefficients(), &self.field, generator);
        Number::new(&self.field, self.field.times(&at(&self.generator), &at(&self.conjugate)))
    }
}
