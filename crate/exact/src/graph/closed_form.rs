//! Dimensions as people write them: log 4 / log 3.

use num_traits::ToPrimitive;

use crate::number::value::Number;

/// The dimension of so many pieces that scale by one ratio, whose square this is, and do not overlap: log n / log(1/r),
/// by whole numbers where that can be, reduced as far as it goes. `None` where the ratio has no short text.
pub(crate) fn closed_form(count: usize, square: &Number) -> Option<String> {
    if count == 1 {
        return Some("0".into());
    }
    let over = Number::whole(1).over(square).ok()?;
    if let Some(over) = over.as_rational().filter(|over| over.is_whole()) {
        return of_whole(count.to_u64()?, over.numerator().to_u64()?);
    }
    let root = over.root(2).and_then(|root| root.in_real_field()).ok().and_then(|root| root.text());
    match root {
        Some(root) => Some(format!("log {count} / log({root})")),
        None => over.text().map(|over| format!("2 log {count} / log({over})")),
    }
}

/// 2 log n / log q.
fn of_whole(n: u64, q: u64) -> Option<String> {
    let ((a, i), (b, j)) = (power(n), power(q));
    let (up, down) = (2 * i, j);
    let common = num_integer::gcd(up, down);
    let (up, down) = (up / common, down / common);
    if a == b {
        return Some(if down == 1 { up.to_string() } else { format!("{up}/{down}") });
    }
    Some(format!("log {} / log {}", a.checked_pow(up)?, b.checked_pow(down)?))
}

/// A number of at least 2 as the power of one that is no power itself.
fn power(n: u64) -> (u64, u32) {
    let of_exponent = |exponent: u32| {
        let near = (n as f64).powf(1.0 / f64::from(exponent)).round() as u64;
        (near >= 2 && near.checked_pow(exponent) == Some(n)).then_some((near, exponent))
    };
    (2..64).rev().find_map(of_exponent).unwrap_or((n, 1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dimensions_have_the_usual_form() {
        for (count, ratio, wanted, value) in [
            (4, "1/3", "log 4 / log 3", 1.261_859_507_142_914_9),
            (3, "1/2", "log 3 / log 2", 1.584_962_500_721_156),
            (2, "1/sqrt(2)", "2", 2.0),
            (8, "1/4", "3/2", 1.5),
            (4, "1/9", "log 2 / log 3", 0.630_929_753_571_457_4),
            (2, "1/sqrt(3)", "log 4 / log 3", 1.261_859_507_142_914_9),
            (7, "1/sqrt(7)", "2", 2.0),
            (5, "(3-sqrt(5))/2", "log 5 / log((3+√5)/2)", 1.672_275_938_184_554_7),
            (2, "2/3", "log 2 / log(3/2)", 1.709_511_291_351_454_8),
            (6, "sqrt((6-sqrt(5))/31)", "2 log 6 / log(6+√5)", 1.699_539_851_192_903),
            (1, "1/3", "0", 0.0),
        ] {
            let square = Number::parse(ratio).unwrap().power(2).unwrap();
            assert_eq!(closed_form(count, &square).as_deref(), Some(wanted), "{ratio}");
            // The text says the value.
            let near = -2.0 * (count as f64).ln() / square.to_f64().ln();
            assert!((near - value).abs() < 1e-12, "{ratio} {near}");
        }
        let strange = Number::parse("cos(40°)/2").unwrap();
        assert_eq!(closed_form(3, &strange), None);
    }
}
