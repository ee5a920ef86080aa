//! Fractions as texts.

use num_bigint::BigInt;

/// A whole number over a positive one.
pub(crate) struct Numeral {
    pub over: BigInt,
    pub under: BigInt,
}

impl Numeral {
    /// `None` for what is not of the form `-7` or `-7/4`.
    pub fn of(text: &str) -> Option<Self> {
        match text.split_once('/') {
            None => Some(Self { over: whole(text)?, under: BigInt::from(1) }),
            Some((over, under)) => {
                let under = natural(under)?;
                (under != BigInt::ZERO).then_some(Self { over: whole(over)?, under })
            }
        }
    }
}

/// Of the form `-7`.
pub(crate) fn whole(text: &str) -> Option<BigInt> {
    text.strip_prefix('-').map_or_else(|| natural(text), |digits| natural(digits).map(|x| -x))
}

fn natural(text: &str) -> Option<BigInt> {
    // More than these, such as a sign or a line below, would be read otherwise.
    let is_one = !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    if is_one { text.parse().ok() } else { None }
}

/// The least common multiple of two positive numbers.
pub(crate) fn common_multiple(a: &BigInt, b: &BigInt) -> BigInt {
    let (mut greater, mut less) = (a.clone(), b.clone());
    while less != BigInt::ZERO {
        (greater, less) = (less.clone(), greater % less);
    }
    a / greater * b
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_plain_fractions_are_read() {
        let read = |text: &str| Numeral::of(text).map(|found| (found.over, found.under));
        for (text, over, under) in [
            ("0", 0, 1),
            ("-0", 0, 1),
            ("007", 7, 1),
            ("-12", -12, 1),
            ("7/4", 7, 4),
            ("-6/4", -6, 4),
            ("0/3", 0, 3),
        ] {
            assert_eq!(read(text), Some((over.into(), under.into())), "{text}");
        }
        for text in [
            "", "-", "/", "1/", "/2", "1/0", "1/-2", "+1", "--1", "1/2/3", "1.5", "1e3", " 1", "1 ", "1_000",
            "٣", "0x1", "1/+2",
        ] {
            assert!(read(text).is_none(), "{text}");
        }
        assert!(whole("1/2").is_none() && whole("-5") == Some((-5).into()));
    }

    #[test]
    fn common_multiples_are_the_least() {
        for a in 1..40_u32 {
            for b in 1..40_u32 {
                let wanted = (1..).find(|n| n % a == 0 && n % b == 0).unwrap();
                assert_eq!(common_multiple(&a.into(), &b.into()), wanted.into(), "{a} {b}");
            }
        }
    }
}
