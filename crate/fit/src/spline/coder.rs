//! A range coder: whole numbers by their shares, in about as many bits as the shares say.
//!
//! After Martin, "Range encoding" (1979), with carries that run back through what is written.

const TOP: u64 = 1 << 56;
const BOTTOM: u64 = 1 << 48;

/// Writes numbers.
#[derive(Clone, Debug)]
pub struct Encoder {
    bytes: Vec<u8>,
    low: u64,
    range: u64,
}

impl Encoder {
    pub fn new() -> Self {
        Self { bytes: Vec::new(), low: 0, range: TOP }
    }

    /// Writes what has `share` of `all` (at most 2^32), behind others that have `below` together.
    pub fn put(&mut self, below: u64, share: u64, all: u64) {
        let part = self.range / all;
        self.low += part * below;
        self.range = part * share;
        if self.low >= TOP {
            self.low -= TOP;
            self.carry();
        }
        while self.range < BOTTOM {
            self.bytes.push((self.low >> 48) as u8);
            self.low = (self.low & (BOTTOM - 1)) << 8;
            self.range <<= 8;
        }
    }

    /// Writes a number below `all`, each as likely as the others.
    pub fn even(&mut self, number: u64, all: u64) {
        self.put(number, 1, all);
    }

    /// Writes a number of so many bits.
    pub fn bits(&mut self, number: u64, many: u32) {
        for i in (0..many).step_by(16) {
            let part = (many - i).min(16);
            self.even(number >> i & ((1 << part) - 1), 1 << part);
        }
    }

    /// Writes a number below 2^60, in twice as many bits as it has.
    pub fn gamma(&mut self, number: u64) {
        let number = number + 1;
        let bits = number.ilog2();
        for _ in 0..bits {
            self.even(1, 2);
        }
        self.even(0, 2);
        self.bits(number & ((1 << bits) - 1), bits);
    }

    fn carry(&mut self) {
        for byte in self.bytes.iter_mut().rev() {
            *byte = byte.wrapping_add(1);
            if *byte != 0 {
                break;
            }
        }
    }

    /// All of it. Zeros at the end are left out: who reads on reads zeros.
    pub fn finish(mut self) -> Vec<u8> {
        // The number of the range that ends in the most zeros.
        let last = self.low + self.range - 1;
        let shift = (0..56).rev().find(|shift| (last >> shift) << shift >= self.low).unwrap_or(0);
        self.low = (last >> shift) << shift;
        if self.low >= TOP {
            self.low -= TOP;
            self.carry();
        }
        self.bytes.extend((0..7).map(|i| (self.low >> (48 - 8 * i)) as u8));
        while self.bytes.last() == Some(&0) {
            self.bytes.pop();
        }
        self.bytes
    }
}

/// Reads what an [`Encoder`] wrote.
#[derive(Clone, Debug)]
pub struct Decoder<'a> {
    bytes: &'a [u8],
    /// How many were read, those after the end among them.
    read: usize,
    code: u64,
    range: u64,
}

impl<'a> Decoder<'a> {
    pub fn new(bytes: &'a [u8]) -> Self {
        let mut decoder = Self { bytes, read: 0, code: 0, range: TOP };
        for _ in 0..7 {
            decoder.next();
        }
        decoder
    }

    fn next(&mut self) {
        let byte = self.bytes.get(self.read).copied().unwrap_or(0);
        self.code = (self.code << 8 | u64::from(byte)) & (TOP - 1);
        self.read += 1;
    }

    /// The place among `all` of what comes next.
    pub fn place(&self, all: u64) -> u64 {
        (self.code / (self.range / all)).min(all - 1)
    }

    /// Goes on behind what has `share` of `all`, behind `below`.
    pub fn take(&mut self, below: u64, share: u64, all: u64) {
        let part = self.range / all;
        self.code = self.code.saturating_sub(part * below);
        self.range = part * share;
        while self.range < BOTTOM {
            self.next();
            self.range <<= 8;
        }
    }

    /// See [`Encoder::even`].
    pub fn even(&mut self, all: u64) -> u64 {
        let number = self.place(all);
        self.take(number, 1, all);
        number
    }

    /// See [`Encoder::bits`].
    pub fn bits(&mut self, many: u32) -> u64 {
        (0..many).step_by(16).fold(0, |number, i| number | self.even(1 << (many - i).min(16)) << i)
    }

    /// See [`Encoder::gamma`]; none where it is of more than 60 bits.
    pub fn gamma(&mut self) -> Option<u64> {
        let mut bits = 0;
        while self.even(2) == 1 {
            bits += 1;
            if bits > 60 {
                return None;
            }
        }
        Some((1_u64 << bits | self.bits(bits)) - 1)
    }

    /// Whether it reads far behind the end.
    pub fn is_past(&self) -> bool {
        self.read > self.bytes.len() + 16
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_is_read_in_as_many_bits_as_it_is_worth() {
        let mut state = 7_u64;
        let mut random = move |below: u64| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) % below
        };
        for round in 0..200 {
            // Shares from even to far from it, which make carries long.
            let all = 1 + random(1 << (1 + round % 31));
            let rare = 1 + random(all);
            let numbers: Vec<bool> = (0..400).map(|_| random(all) < rare).collect();
            let mut encoder = Encoder::new();
            let mut bits = 0.0;
            for &number in &numbers {
                let (below, share) = if number { (0, rare) } else { (rare, all - rare) };
                encoder.put(below, share, all);
                bits -= (share as f64 / all as f64).log2();
            }
            for number in [0, 1, 2, 77, round, (1 << 41) + 5] {
                encoder.gamma(number);
            }
            let bytes = encoder.finish();
            assert!((bytes.len() as f64) < bits / 8.0 + 23.0);
            let mut decoder = Decoder::new(&bytes);
            for &number in &numbers {
                assert_eq!(decoder.place(all) < rare, number);
                let (below, share) = if number { (0, rare) } else { (rare, all - rare) };
                decoder.take(below, share, all);
            }
            for number in [0, 1, 2, 77, round, (1 << 41) + 5] {
                assert_eq!(decoder.gamma(), Some(number));
            }
            assert!(!decoder.is_past());
        }
    }
}
