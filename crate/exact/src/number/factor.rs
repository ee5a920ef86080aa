//! The irreducible factors of polynomials with whole coefficients (Zassenhaus 1969): modulo a prime, then modulo its
//! powers by Hensel's lemma, up to the bound of Mignotte (1974) for coefficients of factors.

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed, Zero};

use crate::error::ExactError;
use crate::number::modular::{self, Residues};
use crate::number::polynomial::{Polynomial, without_content};

/// The degree up to which polynomials are factored.
pub(crate) const LARGEST_DEGREE: usize = 64;
/// Sets of factors modulo a prime that are tried.
const MOST_TRIALS: usize = 6_000;
const PRIMES: [u64; 24] =
    [3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53, 59, 61, 67, 71, 73, 79, 83, 89, 97];
/// Primes that are tried for the one with the fewest factors.
const MOST_COMPARED: usize = 5;

/// The different irreducible factors, each with whole coefficients and a positive leading one.
pub(crate) fn factors(polynomial: &Polynomial) -> Result<Vec<Vec<BigInt>>, ExactError> {
    if polynomial.degree() > LARGEST_DEGREE {
        return Err(ExactError::DegreeTooLarge { degree: polynomial.degree(), most: LARGEST_DEGREE });
    }
    if polynomial.degree() == 0 {
        return Ok(Vec::new());
    }
    let repeated = polynomial.gcd(&polynomial.derivative());
    let squarefree = polynomial.divided(&repeated).map_or_else(Polynomial::default, |(quotient, _)| quotient);
    let mut f = squarefree.primitive();
    let mut found = Vec::new();
    if f[0].is_zero() {
        found.push(vec![BigInt::zero(), BigInt::one()]);
        f.remove(0);
    }
    if f.len() == 2 {
        found.push(f);
    } else if f.len() > 2 {
        found.extend(of_squarefree(f)?);
    }
    Ok(found)
}

fn of_squarefree(f: Vec<BigInt>) -> Result<Vec<Vec<BigInt>>, ExactError> {
    let suits = |prime: u64| {
        let residues = modular::residues(&f, prime);
        (residues.len() == f.len() && modular::is_squarefree(&residues, prime))
            .then(|| (prime, modular::factors(&residues, prime)))
    };
    let found = PRIMES.into_iter().filter_map(suits).take(MOST_COMPARED);
    let (prime, modular) =
        found.min_by_key(|(_, factors)| factors.len()).ok_or(ExactError::FactoringTooHard)?;
    if modular.len() == 1 {
        return Ok(vec![f]);
    }
    let size = f.iter().fold(BigInt::zero(), |sum, c| sum + c.abs());
    let bound = (size * &f[f.len() - 1]) << (f.len() + 1);
    let mut modulus = BigInt::from(prime);
    let mut steps = 1;
    while modulus <= bound {
        modulus *= prime;
        steps += 1;
    }
    let lifted = lifted(&f, &modular, prime, steps);
    recombined(f, lifted, &modulus)
}

/// Factors modulo a power of the prime, from those modulo the prime.
fn lifted(f: &[BigInt], factors: &[Residues], prime: u64, steps: usize) -> Vec<Vec<BigInt>> {
    let modulus = num_traits::pow(BigInt::from(prime), steps);
    let lead = f[f.len() - 1].extended_gcd(&modulus).x;
    let mut rest: Vec<BigInt> = f.iter().map(|c| (c * &lead).mod_floor(&modulus)).collect();
    let mut all = Vec::new();
    for (k, g) in factors.iter().enumerate() {
        if k + 1 == factors.len() {
            all.push(rest);
            break;
        }
        let h = factors[k + 1..].iter().fold(vec![1], |h, factor| modular::product(&h, factor, prime));
        let (g, h) = lifted_pair(&rest, g, &h, prime, steps);
        all.push(g);
        rest = h;
    }
    all
}

/// `f = g h` modulo the prime, lifted to its power, for monic f, g and h.
fn lifted_pair(f: &[BigInt], g: &[u64], h: &[u64], prime: u64, steps: usize) -> (Vec<BigInt>, Vec<BigInt>) {
    let (s, t) = modular::bezout(g, h, prime);
    let long = |residues: &[u64]| residues.iter().map(|&c| BigInt::from(c)).collect::<Vec<_>>();
    let (mut long_g, mut long_h) = (long(g), long(h));
    let mut power = BigInt::from(prime);
    for _ in 1..steps {
        // What is missing, in units of the power so far; then g' = g + p^k (t e mod g), h' = h + p^k (s e mod h).
        let product = whole_product(&long_g, &long_h);
        let missing: Vec<BigInt> = f.iter().zip(product).map(|(f, p)| (f - p) / &power).collect();
        let missing = modular::residues(&missing, prime);
        for (long, modulus, cofactor) in [(&mut long_g, g, &t), (&mut long_h, h, &s)] {
            let change = modular::divided(&modular::product(cofactor, &missing, prime), modulus, prime).1;
            for (c, change) in long.iter_mut().zip(change) {
                *c += &power * change;
            }
        }
        power *= prime;
    }
    (long_g, long_h)
}

fn whole_product(a: &[BigInt], b: &[BigInt]) -> Vec<BigInt> {
    let mut all = vec![BigInt::zero(); a.len() + b.len() - 1];
    for (i, x) in a.iter().enumerate() {
        for (j, y) in b.iter().enumerate() {
            all[i + j] += x * y;
        }
    }
    all
}

/// Products of lifted factors that divide the polynomial.
fn recombined(
    mut f: Vec<BigInt>,
    mut lifted: Vec<Vec<BigInt>>,
    modulus: &BigInt,
) -> Result<Vec<Vec<BigInt>>, ExactError> {
    let (mut found, mut size, mut trials) = (Vec::new(), 1, 0);
    while 2 * size <= lifted.len() {
        let mut chosen: Vec<usize> = (0..size).collect();
        let mut divisor = None;
        loop {
            trials += 1;
            if trials > MOST_TRIALS {
                return Err(ExactError::FactoringTooHard);
            }
            if let Some((factor, quotient)) = divided_by(&f, &chosen, &lifted, modulus) {
                divisor = Some((factor, quotient));
                break;
            }
            if !advance(&mut chosen, lifted.len()) {
                break;
            }
        }
        if let Some((factor, quotient)) = divisor {
            found.push(factor);
            f = quotient;
            let mut k = 0;
            lifted.retain(|_| {
                k += 1;
                !chosen.contains(&(k - 1))
            });
        } else {
            size += 1;
        }
    }
    if f.len() > 1 {
        found.push(f);
    }
    Ok(found)
}

fn divided_by(
    f: &[BigInt],
    chosen: &[usize],
    lifted: &[Vec<BigInt>],
    modulus: &BigInt,
) -> Option<(Vec<BigInt>, Vec<BigInt>)> {
    let (half, lead) = (modulus / 2, &f[f.len() - 1]);
    let symmetric = |c: BigInt| if c > half { c - modulus } else { c };
    // Few sets have a constant term that divides, as that of a factor does: the others are told at once.
    let constant = chosen.iter().fold(lead.clone(), |c, &k| (c * &lifted[k][0]).mod_floor(modulus));
    let constant = symmetric(constant);
    if constant.is_zero() || !(lead * &f[0]).is_multiple_of(&constant) {
        return None;
    }
    let mut product = vec![lead.clone()];
    for &k in chosen {
        product = whole_product(&product, &lifted[k]);
        for c in &mut product {
            *c = c.mod_floor(modulus);
        }
    }
    let factor = without_content(product.into_iter().map(symmetric).collect());
    let (quotient, rest) = Polynomial::of_whole(f).divided(&Polynomial::of_whole(&factor))?;
    rest.is_zero().then(|| (factor, quotient.primitive()))
}

/// The next set of so many numbers below n.
fn advance(chosen: &mut [usize], n: usize) -> bool {
    let size = chosen.len();
    for k in (0..size).rev() {
        if chosen[k] + size - k < n {
            chosen[k] += 1;
            for j in k + 1..size {
                chosen[j] = chosen[j - 1] + 1;
            }
            return true;
        }
    }
    false
}

#[cfg(test)]
mod tests {
    use super::*;

    fn whole(coefficients: &[i64]) -> Polynomial {
        Polynomial::of_whole(&coefficients.iter().map(|&c| c.into()).collect::<Vec<_>>())
    }

    fn found(coefficients: &[i64]) -> Vec<Vec<BigInt>> {
        let mut found = factors(&whole(coefficients)).unwrap();
        found.sort();
        found
    }

    fn wanted(all: &[&[i64]]) -> Vec<Vec<BigInt>> {
        let mut all: Vec<Vec<BigInt>> = all.iter().map(|f| f.iter().map(|&c| c.into()).collect()).collect();
        all.sort();
        all
    }

    #[test]
    fn known_factors_are_found() {
        // x^4 + 4 = (x^2 - 2x + 2)(x^2 + 2x + 2), of Sophie Germain.
        assert_eq!(found(&[4, 0, 0, 0, 1]), wanted(&[&[2, -2, 1], &[2, 2, 1]]));
        // x^12 - 1: the six cyclotomic polynomials of the divisors of 12.
        assert_eq!(
            found(&[-1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1]),
            wanted(&[&[-1, 1], &[1, 1], &[1, 1, 1], &[1, 0, 1], &[1, -1, 1], &[1, 0, -1, 0, 1]])
        );
        // (2x - 1)(3x + 2) x^2.
        assert_eq!(found(&[0, 0, -2, 1, 6]), wanted(&[&[0, 1], &[-1, 2], &[2, 3]]));
    }

    #[test]
    fn what_splits_modulo_all_primes_stays_whole() {
        // The polynomials of sqrt 2 + sqrt 3, and of sqrt 2 + sqrt 3 + sqrt 5 (Swinnerton-Dyer).
        assert_eq!(found(&[1, 0, -10, 0, 1]), wanted(&[&[1, 0, -10, 0, 1]]));
        let dyer = [576, 0, -960, 0, 352, 0, -40, 0, 1];
        assert_eq!(found(&dyer), wanted(&[&dyer]));
    }
}
