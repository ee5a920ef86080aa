//! The shifts by which two shapes of a grid reach each other.

use std::collections::HashMap;
use std::collections::hash_map::Entry;

use crate::digits::error::DigitError;
use crate::digits::reach::Reach;
use crate::digits::system::DigitSystem;

/// A way from a shift to the next.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(crate) struct Way {
    /// The digit of the first shape.
    pub digit: usize,
    /// The shift that it leads to.
    pub to: usize,
}

/// The shifts with an endless way, and the ways from each. The first is the one that was asked for; none at all where
/// the shapes do not meet.
#[derive(Clone, Debug, Default)]
pub(crate) struct ShiftGraph {
    /// Numerators, over the denominator that was asked for.
    pub shifts: Vec<[i64; 2]>,
    pub ways: Vec<Vec<Way>>,
}

/// Shifts and ways that are followed at most.
pub(crate) const MOST_SHIFTS: usize = 20_000;
const MOST_WAYS: usize = 2_000_000;

impl ShiftGraph {
    /// All shifts that p / q leads to: from t to `M t + d' - d`, by a digit d of the first and d' of the second.
    pub fn of(first: &DigitSystem, second: &DigitSystem, p: [i64; 2], q: i64) -> Result<Self, DigitError> {
        let mut by_difference: HashMap<[i64; 2], Vec<usize>> = HashMap::new();
        let mut differences = Vec::new();
        for (digit, a) in first.digits().iter().enumerate() {
            for b in second.digits() {
                let difference = [a[0] - b[0], a[1] - b[1]];
                let digits = by_difference.entry(difference).or_insert_with(|| {
                    differences.push(difference);
                    Vec::new()
                });
                digits.push(digit);
            }
        }
        let reach = Reach::of(first.matrix(), &differences)?;
        if !reach.holds(p, q) {
            return Ok(Self::default());
        }
        let [a, b, c, d] = first.matrix().map(i128::from);
        let mut known = HashMap::from([(p, 0)]);
        let mut this = Self { shifts: vec![p], ways: Vec::new() };
        let mut count = 0;
        while this.ways.len() < this.shifts.len() {
            let [x, y] = this.shifts[this.ways.len()];
            let mut ways = Vec::new();
            let [x, y] = [i128::from(x), i128::from(y)];
            let [x, y] = [a * x + b * y, c * x + d * y];
            for difference in &differences {
                let [e, f] = difference.map(|e| i128::from(q) * i128::from(e));
                let next = i64::try_from(x - e).and_then(|x| Ok([x, i64::try_from(y - f)?]));
                let next = next.map_err(|_| DigitError::TooLarge)?;
                if !reach.holds(next, q) {
                    continue;
                }
                let most = this.shifts.len();
                let to = match known.entry(next) {
                    Entry::Occupied(entry) => *entry.get(),
                    Entry::Vacant(_) if most >= MOST_SHIFTS => {
                        return Err(DigitError::TooManyShifts { most: MOST_SHIFTS });
                    }
                    Entry::Vacant(entry) => {
                        this.shifts.push(next);
                        *entry.insert(most)
                    }
                };
                let digits = &by_difference[difference];
                count += digits.len();
                if count > MOST_WAYS {
                    return Err(DigitError::TooManyShifts { most });
                }
                ways.extend(digits.iter().map(|&digit| Way { digit, to }));
            }
            this.ways.push(ways);
        }
        Ok(this.endless())
    }

    /// Without the shifts from which every way ends.
    fn endless(self) -> Self {
        let count = self.shifts.len();
        let mut into: Vec<Vec<usize>> = vec![Vec::new(); count];
        for (from, ways) in self.ways.iter().enumerate() {
            ways.iter().for_each(|way| into[way.to].push(from));
        }
        let mut left: Vec<usize> = self.ways.iter().map(Vec::len).collect();
        let mut ended: Vec<usize> = (0..count).filter(|&shift| left[shift] == 0).collect();
        while let Some(shift) = ended.pop() {
            for &from in &into[shift] {
                left[from] -= 1;
                if left[from] == 0 {
                    ended.push(from);
                }
            }
        }
        if left.first().is_none_or(|&ways| ways == 0) {
            return Self::default();
        }
        let mut name = vec![0; count];
        let mut shifts = Vec::new();
        for shift in (0..count).filter(|&shift| left[shift] > 0) {
            name[shift] = shifts.len();
            shifts.push(self.shifts[shift]);
        }
        let kept = |ways: Vec<Way>| -> Vec<Way> {
            let alive = ways.into_iter().filter(|way| left[way.to] > 0);
            alive.map(|way| Way { to: name[way.to], ..way }).collect()
        };
        let ways = self.ways.into_iter().enumerate().filter(|(shift, _)| left[*shift] > 0);
        Self { ways: ways.map(|(_, ways)| kept(ways)).collect(), shifts }
    }
}
