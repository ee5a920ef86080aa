//! Polynomials modulo a small prime, and their factors (Berlekamp 1967).

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::ToPrimitive;

/// Coefficients below the prime, the constant term first, the last not zero.
pub(crate) type Residues = Vec<u64>;

pub(crate) fn residues(coefficients: &[BigInt], prime: u64) -> Residues {
    let modulus = BigInt::from(prime);
    trimmed(coefficients.iter().map(|c| c.mod_floor(&modulus).to_u64().unwrap_or(0)).collect())
}

fn trimmed(mut f: Residues) -> Residues {
    while f.last() == Some(&0) {
        f.pop();
    }
    f
}

pub(crate) fn inverse(value: u64, prime: u64) -> u64 {
    // Fermat's little theorem.
    let (mut base, mut exponent, mut power) = (value % prime, prime - 2, 1);
    while exponent > 0 {
        if exponent & 1 == 1 {
            power = power * base % prime;
        }
        base = base * base % prime;
        exponent >>= 1;
    }
    power
}

pub(crate) fn product(a: &[u64], b: &[u64], prime: u64) -> Residues {
    if a.is_empty() || b.is_empty() {
        return Vec::new();
    }
    let mut all = vec![0; a.len() + b.len() - 1];
    for (i, x) in a.iter().enumerate() {
        for (j, y) in b.iter().enumerate() {
            all[i + j] = (all[i + j] + x * y) % prime;
        }
    }
    trimmed(all)
}

fn difference(a: &[u64], b: &[u64], prime: u64) -> Residues {
    let at = |f: &[u64], k: usize| f.get(k).copied().unwrap_or(0);
    trimmed((0..a.len().max(b.len())).map(|k| (at(a, k) + prime - at(b, k)) % prime).collect())
}

/// Quotient and remainder. The divisor is not zero.
pub(crate) fn divided(a: &[u64], b: &[u64], prime: u64) -> (Residues, Residues) {
    let lead = inverse(b[b.len() - 1], prime);
    let mut rest = a.to_vec();
    let mut quotient = vec![0; (a.len() + 1).saturating_sub(b.len())];
    for k in (0..quotient.len()).rev() {
        let factor = rest[k + b.len() - 1] * lead % prime;
        for (j, d) in b.iter().enumerate() {
            rest[k + j] = (rest[k + j] + (prime - factor) * d) % prime;
        }
        quotient[k] = factor;
    }
    (trimmed(quotient), trimmed(rest))
}

pub(crate) fn monic(f: &[u64], prime: u64) -> Residues {
    let Some(&lead) = f.last() else { return Vec::new() };
    let scale = inverse(lead, prime);
    f.iter().map(|c| c * scale % prime).collect()
}

pub(crate) fn gcd(a: &[u64], b: &[u64], prime: u64) -> Residues {
    let (mut a, mut b) = (a.to_vec(), b.to_vec());
    while !b.is_empty() {
        let rest = divided(&a, &b, prime).1;
        (a, b) = (b, rest);
    }
    monic(&a, prime)
}

/// `(s, t)` with `s a + t b = 1`, for coprime a and b.
pub(crate) fn bezout(a: &[u64], b: &[u64], prime: u64) -> (Residues, Residues) {
    let (mut r, mut next) = (a.to_vec(), b.to_vec());
    let (mut s, mut s_next, mut t, mut t_next) = (vec![1], Vec::new(), Vec::new(), vec![1]);
    while !next.is_empty() {
        let (quotient, rest) = divided(&r, &next, prime);
        let s_after = difference(&s, &product(&quotient, &s_next, prime), prime);
        let t_after = difference(&t, &product(&quotient, &t_next, prime), prime);
        (r, next) = (next, rest);
        (s, s_next, t, t_next) = (s_next, s_after, t_next, t_after);
    }
    let scale = [inverse(r.first().copied().unwrap_or(1), prime)];
    (product(&s, &scale, prime), product(&t, &scale, prime))
}

pub(crate) fn is_squarefree(f: &[u64], prime: u64) -> bool {
    let slopes = f.iter().enumerate().skip(1).map(|(k, c)| k as u64 % prime * c % prime).collect();
    gcd(f, &trimmed(slopes), prime).len() == 1
}

/// The monic irreducible factors of a squarefree polynomial.
pub(crate) fn factors(f: &[u64], prime: u64) -> Vec<Residues> {
    let f = monic(f, prime);
    let basis = fixed(&f, prime);
    let mut found = vec![f];
    for element in basis.iter().filter(|element| element.len() > 1) {
        for shift in 0..prime {
            if found.len() == basis.len() {
                return found;
            }
            let shifted = difference(element, &trimmed(vec![shift]), prime);
            let mut parts = Vec::new();
            for factor in found {
                let common = gcd(&factor, &shifted, prime);
                if common.len() > 1 && common.len() < factor.len() {
                    parts.push(divided(&factor, &common, prime).0);
                    parts.push(common);
                } else {
                    parts.push(factor);
                }
            }
            found = parts;
        }
    }
    found
}

/// A basis of the polynomials with `g^p = g` modulo f.
fn fixed(f: &[u64], prime: u64) -> Vec<Residues> {
    let n = f.len() - 1;
    // Row k is x^(p k) - x^k.
    let mut step = vec![1];
    for _ in 0..prime {
        let mut shifted = vec![0];
        shifted.extend(&step);
        step = divided(&trimmed(shifted), f, prime).1;
    }
    let (mut power, mut rows) = (vec![1], Vec::new());
    for k in 0..n {
        let mut row = power.clone();
        row.resize(n, 0);
        row[k] = (row[k] + prime - 1) % prime;
        rows.push(row);
        power = divided(&product(&power, &step, prime), f, prime).1;
    }
    // The kernel of the transpose: combinations of rows that vanish.
    let mut combinations: Vec<Residues> =
        (0..n).map(|k| (0..n).map(|j| u64::from(j == k)).collect()).collect();
    let mut used = vec![false; n];
    for column in 0..n {
        let Some(pivot) = (0..n).find(|&k| !used[k] && rows[k][column] != 0) else { continue };
        used[pivot] = true;
        let scale = inverse(rows[pivot][column], prime);
        for k in (0..n).filter(|&k| k != pivot) {
            let factor = rows[k][column] * scale % prime;
            if factor != 0 {
                for j in 0..n {
                    rows[k][j] = (rows[k][j] + (prime - factor) * rows[pivot][j]) % prime;
                    combinations[k][j] =
                        (combinations[k][j] + (prime - factor) * combinations[pivot][j]) % prime;
                }
            }
        }
    }
    (0..n).filter(|&k| !used[k]).map(|k| trimmed(combinations[k].clone())).collect()
}
