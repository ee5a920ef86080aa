//! Codes and how they are shuffled.

/// The most symbols that a code may have: they are bytes.
pub const MAX_SYMBOLS: usize = 256;

/// `D_e-u(kb, k)`: the symbol in place k moves to place kb + 1, and those it passes move on by one (Fujimoto et
/// al., eqs 2 and 3). Places count from 1, as in the paper. Where there is nothing to move, the code stays.
pub fn step(code: &mut [u8], kb: usize, k: usize) {
    if kb < k && k <= code.len() {
        code[kb..k].rotate_right(1);
    }
}

/// `D_e-uni(kb, ke)`: the block of places kb + 1 to ke is reversed, the rest stays (Fujimoto et al., definition 2,
/// whose recursion comes to this; eqs 5 and 6 are garbled in print). It is its own inverse.
///
/// A code that is shorter than `ke` cannot be shuffled so: it stays as it is. Below `kb`, `ke` counts as `kb`.
pub fn shuffle(code: &mut [u8], kb: usize, ke: usize) {
    if kb < ke && ke <= code.len() {
        code[kb..ke].reverse();
    }
}

/// Where [`shuffle`] takes each word of so many letters: words are numbered in the order of a dictionary, the
/// first letter being the most significant. An attribute is rearranged by `out[i] = a[permutation[i]]`
/// (Fujimoto et al., eq 11). `None` for no symbols, or more words than fit 32 bits.
#[must_use]
pub fn permutation(symbols: usize, letters: usize, kb: usize, ke: usize) -> Option<Vec<u32>> {
    let count = symbols.checked_pow(u32::try_from(letters).ok()?).filter(|&n| n <= u32::MAX as usize)?;
    if symbols == 0 || symbols > MAX_SYMBOLS {
        return None;
    }
    let mut code = vec![0; letters];
    let index = |number: usize| {
        let mut left = number;
        for symbol in code.iter_mut().rev() {
            *symbol = (left % symbols) as u8;
            left /= symbols;
        }
        shuffle(&mut code, kb, ke);
        code.iter().fold(0, |number, &symbol| number * symbols + usize::from(symbol)) as u32
    };
    Some((0..count).map(index).collect())
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// Equation 4, word for word.
    fn by_recursion(code: &mut [u8], kb: usize, ke: usize) {
        if kb < ke {
            by_recursion(code, kb, ke - 1);
            step(code, kb, ke);
        }
    }

    proptest! {
        #[test]
        fn the_recursion_reverses_a_block_and_undoes_itself(
            code in proptest::collection::vec(0..7_u8, 0..12), kb in 0..12_usize, ke in 0..12_usize,
        ) {
            let ke = ke.min(code.len());
            let (mut once, mut slow) = (code.clone(), code.clone());
            shuffle(&mut once, kb, ke);
            by_recursion(&mut slow, kb, ke);
            prop_assert_eq!(&once, &slow);
            shuffle(&mut once, kb, ke);
            prop_assert_eq!(once, code);
        }
    }

    #[test]
    fn what_cannot_be_shuffled_stays() {
        let mut code = [1, 2, 3];
        shuffle(&mut code, 0, 4);
        shuffle(&mut code, 2, 1);
        step(&mut code, 1, 9);
        assert_eq!(code, [1, 2, 3]);
        assert_eq!(permutation(0, 3, 0, 3), None);
        assert_eq!(permutation(64, 6, 0, 3), None);
        assert_eq!(permutation(1, 5, 0, 5), Some(vec![0]));
    }
}
