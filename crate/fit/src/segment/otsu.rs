//! Where a histogram falls in two.

/// Two classes of grey values and the line between them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Level {
    /// Values above it are of the bright class.
    pub level: f64,
    /// The part of the spread that lies between the classes: 0 where there is one value only, at most 1.
    pub separation: f64,
    /// The mean of the dark class.
    pub dark: f64,
    /// The mean of the bright class.
    pub bright: f64,
}

/// The line that leaves the least spread within its two classes (Otsu 1979): half way between their means.
///
/// None where all values are the same.
#[inline(never)]
pub fn split(counts: &[u64; 256]) -> Option<Level> {
    let all: u64 = counts.iter().sum();
    let weighed = |k: usize| k as f64 * counts[k] as f64;
    let sum: f64 = (0..256).map(weighed).sum();
    let mean = sum / all.max(1) as f64;
    let spread: f64 = (0..256).map(|k| (k as f64 - mean).powi(2) * counts[k] as f64).sum();
    if spread <= 0.0 {
        return None;
    }
    let (mut below, mut below_sum) = (0_u64, 0.0);
    let mut best: Option<(f64, usize, usize, f64, f64)> = None;
    for (k, &count) in counts[..255].iter().enumerate() {
        below += count;
        below_sum += weighed(k);
        let above = all - below;
        if below == 0 || above == 0 {
            continue;
        }
        let (dark, bright) = (below_sum / below as f64, (sum - below_sum) / above as f64);
        let between = below as f64 * above as f64 / all as f64 * (bright - dark).powi(2);
        match &mut best {
            // A gap in the histogram: any line through it is as good, and its middle is meant.
            Some((most, _, last, ..)) if between >= *most * (1.0 - 1e-12) && *last + 1 == k && count == 0 => {
                *last = k;
            }
            Some((most, ..)) if between <= *most => {}
            _ => best = Some((between, k, k, dark, bright)),
        }
    }
    best.map(|(between, first, last, dark, bright)| Level {
        level: 0.5 * (first + last) as f64 + 0.5,
        separation: (between / spread).clamp(0.0, 1.0),
        dark,
        bright,
    })
}

/// How often each value comes.
pub fn histogram(values: &[u8]) -> [u64; 256] {
    let mut counts = [0; 256];
    count(values, &mut counts);
    counts
}

/// Adds how often each value comes. Neighbours are mostly alike: each of four has a table of its own, and need not wait
/// for the one before it.
#[inline(never)]
pub fn count(values: &[u8], counts: &mut [u64; 256]) {
    let mut tables = [[0_u32; 256]; 4];
    let fours = values.chunks_exact(4);
    for &value in fours.remainder() {
        counts[usize::from(value)] += 1;
    }
    for four in fours {
        for (table, &value) in tables.iter_mut().zip(four) {
            table[usize::from(value)] += 1;
        }
    }
    for (value, count) in counts.iter_mut().enumerate() {
        *count += tables.iter().map(|table| u64::from(table[value])).sum::<u64>();
    }
}

/// The value that the given share (0 to 1) of all lies at or below.
pub fn quantile(counts: &[u64; 256], share: f64) -> u8 {
    let all: u64 = counts.iter().sum();
    let wanted = (share * all as f64).ceil().max(1.0) as u64;
    let mut below = 0;
    for (value, count) in (0..=u8::MAX).zip(counts) {
        below += count;
        if below >= wanted {
            return value;
        }
    }
    u8::MAX
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_values_are_parted_in_their_middle() {
        let mut counts = [0; 256];
        counts[40] = 900;
        counts[240] = 100;
        let found = split(&counts).map(|l| (l.level, l.separation, l.dark, l.bright));
        assert_eq!(found, Some((140.0, 1.0, 40.0, 240.0)));
        counts[240] = 0;
        assert_eq!(split(&counts), None);
        assert_eq!(split(&[0; 256]), None);
    }

    #[test]
    fn quantiles_are_counted_from_below() {
        let counts = histogram(&[1, 2, 3, 4]);
        assert_eq!((quantile(&counts, 0.0), quantile(&counts, 0.5), quantile(&counts, 1.0)), (1, 2, 4));
    }
}
