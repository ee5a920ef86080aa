//! Yes or no for each pixel, and what grows and shrinks it.

/// A picture of yes and no, row after row.
#[derive(Clone, Debug, PartialEq)]
pub struct Bits {
    pub width: usize,
    pub height: usize,
    pub on: Vec<bool>,
}

impl Bits {
    pub fn new(width: usize, height: usize) -> Self {
        Self { width, height, on: vec![false; width * height] }
    }

    /// The pixels whose value is above a level.
    pub fn above(values: &[u8], width: usize, height: usize, level: f64) -> Self {
        let least = (0..=u8::MAX).find(|&value| f64::from(value) > level);
        let on = match least {
            Some(least) => values.iter().map(|&value| value >= least).collect(),
            None => vec![false; values.len()],
        };
        Self { width, height, on }
    }

    /// What is within left, top, right and bottom; right and bottom are the first outside.
    pub fn cut(&self, [left, top, right, bottom]: [usize; 4]) -> Self {
        let rows = (top..bottom).map(|y| &self.on[y * self.width + left..y * self.width + right]);
        Self { width: right - left, height: bottom - top, on: rows.flatten().copied().collect() }
    }

    /// The same on a larger picture, with its upper left corner there; all around is off.
    pub fn placed(&self, width: usize, height: usize, left: usize, top: usize) -> Self {
        let mut all = Self::new(width, height);
        for (y, row) in self.on.chunks_exact(self.width).enumerate() {
            let start = (top + y) * width + left;
            all.on[start..start + row.len()].copy_from_slice(row);
        }
        all
    }

    /// How many are on.
    pub fn count(&self) -> usize {
        self.on.iter().filter(|&&on| on).count()
    }

    /// How many neighbours above and beside each other differ.
    pub fn edges(&self) -> usize {
        let mut edges = 0;
        let mut above: Option<&[bool]> = None;
        for row in self.on.chunks_exact(self.width) {
            edges += row.windows(2).filter(|pair| pair[0] != pair[1]).count();
            if let Some(above) = above {
                edges += row.iter().zip(above).filter(|(a, b)| a != b).count();
            }
            above = Some(row);
        }
        edges
    }

    /// What is left where a square of 2 `radius` + 1 pixels fits in. Beyond the border all counts as on, so that
    /// nothing is eaten from there.
    pub fn opened_by_square(&self, radius: usize) -> Self {
        let mut work = self.clone();
        work.squeeze(radius, false);
        work.squeeze(radius, true);
        work
    }

    /// Makes each pixel `to` that has one that is so within a square.
    fn squeeze(&mut self, radius: usize, to: bool) {
        let mut before = Vec::new();
        for row in self.on.chunks_exact_mut(self.width) {
            before.clear();
            before.extend_from_slice(row);
            spread(&before, radius, to, |i| row[i] = to);
        }
        // How many rows ago each column had one, down and up: row by row, as pixels lie in memory.
        let radius = u16::try_from(radius).unwrap_or(u16::MAX).min(u16::MAX - 1);
        let mut near = vec![false; self.on.len()];
        let mut since = vec![u16::MAX; self.width];
        let rows = || self.on.chunks_exact(self.width);
        for (row, near) in rows().zip(near.chunks_exact_mut(self.width)) {
            see(row, to, radius, &mut since, near);
        }
        since.fill(u16::MAX);
        for (row, near) in rows().zip(near.chunks_exact_mut(self.width)).rev() {
            see(row, to, radius, &mut since, near);
        }
        near.iter_mut().for_each(|near| *near = *near == to);
        self.on = near;
    }

    /// All pixels at most `radius` from one that is on.
    pub fn grown(&self, radius: f64) -> Self {
        self.where_distance(true, |squared| squared <= radius * radius)
    }

    /// The pixels that are more than `radius` from all that are off. Beyond the border all counts as on.
    pub fn shrunk(&self, radius: f64) -> Self {
        self.where_distance(false, |squared| squared > radius * radius)
    }

    /// What a disc covers that stays within.
    pub fn opened(&self, radius: f64) -> Self {
        self.shrunk(radius).grown(radius)
    }

    fn where_distance(&self, from: bool, keep: impl Fn(f64) -> bool) -> Self {
        let on = squared_distances(self, from).iter().map(|&squared| keep(f64::from(squared))).collect();
        Self { width: self.width, height: self.height, on }
    }
}

/// Takes the next row, and notes where the last that was `wanted` is at most `radius` rows away.
fn see(row: &[bool], wanted: bool, radius: u16, since: &mut [u16], near: &mut [bool]) {
    for ((&on, since), near) in row.iter().zip(since).zip(near) {
        *since = if on == wanted { 0 } else { since.saturating_add(1) };
        *near |= *since <= radius;
    }
}

/// Calls for each place at most `radius` from one that is `wanted`.
fn spread(line: &[bool], radius: usize, wanted: bool, mut mark: impl FnMut(usize)) {
    let mut done = 0;
    for (i, _) in line.iter().enumerate().filter(|(_, on)| **on == wanted) {
        let (from, to) = (i.saturating_sub(radius).max(done), (i + radius + 1).min(line.len()));
        for place in from..to {
            mark(place);
        }
        done = done.max(to);
    }
}

/// The square of the distance from each pixel to the nearest whose bit is `from`; infinite where there is none. In
/// linear time (Felzenszwalb & Huttenlocher 2012).
pub fn squared_distances(bits: &Bits, from: bool) -> Vec<f32> {
    let (width, height) = (bits.width, bits.height);
    let mut squares = vec![f32::INFINITY; width * height];
    // Down and up, row by row: how far the next one of each column is.
    let mut far = vec![f32::INFINITY; width];
    for (row, squares) in bits.on.chunks_exact(width).zip(squares.chunks_exact_mut(width)) {
        for ((&on, far), square) in row.iter().zip(&mut far).zip(squares) {
            *far = if on == from { 0.0 } else { *far + 1.0 };
            *square = *far;
        }
    }
    far.fill(f32::INFINITY);
    for (row, squares) in bits.on.chunks_exact(width).zip(squares.chunks_exact_mut(width)).rev() {
        for ((&on, far), square) in row.iter().zip(&mut far).zip(squares) {
            *far = if on == from { 0.0 } else { *far + 1.0 };
            *square = square.min(*far) * square.min(*far);
        }
    }
    let mut tops: Vec<(usize, f64)> = Vec::with_capacity(width);
    let mut row_before = Vec::with_capacity(width);
    for row in squares.chunks_exact_mut(width) {
        row_before.clear();
        row_before.extend_from_slice(row);
        tops.clear();
        // The lower envelope of a parabola at each place: where each begins to be the lowest.
        for (place, &height) in row_before.iter().enumerate().filter(|(_, height)| height.is_finite()) {
            let begin = loop {
                let Some(&(top, since)) = tops.last() else { break f64::NEG_INFINITY };
                let square = |at: usize| (at * at) as f64;
                let rise = f64::from(height) + square(place) - f64::from(row_before[top]) - square(top);
                let meet = rise / (2 * (place - top)) as f64;
                if meet > since {
                    break meet;
                }
                tops.pop();
            };
            tops.push((place, begin));
        }
        let mut k = 0;
        for (place, square) in row.iter_mut().enumerate() {
            while tops.get(k + 1).is_some_and(|next| next.1 <= place as f64) {
                k += 1;
            }
            *square = tops.get(k).map_or(f32::INFINITY, |&(top, _)| {
                let far = place.abs_diff(top) as f32;
                far * far + row_before[top]
            });
        }
    }
    squares
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distances_are_those_of_trying_all() {
        let mut bits = Bits::new(13, 9);
        for i in [0, 17, 58, 60, 99, 101] {
            bits.on[i] = true;
        }
        let squares = squared_distances(&bits, true);
        for (i, &square) in squares.iter().enumerate() {
            let (x, y) = ((i % 13) as f32, (i / 13) as f32);
            let to = |j: usize| (x - (j % 13) as f32).powi(2) + (y - (j / 13) as f32).powi(2);
            let least = (0..bits.on.len()).filter(|&j| bits.on[j]).map(to).fold(f32::INFINITY, f32::min);
            assert_eq!(square, least, "pixel {i}");
        }
        assert!(squared_distances(&Bits::new(3, 3), true).iter().all(|square| square.is_infinite()));
    }

    #[test]
    fn what_is_cut_goes_back_to_its_place() {
        let mut bits = Bits::new(7, 5);
        for i in [8, 9, 17, 23] {
            bits.on[i] = true;
        }
        let cut = bits.cut([1, 1, 4, 4]);
        assert_eq!((cut.width, cut.height, cut.count()), (3, 3, 4));
        assert_eq!(cut.placed(7, 5, 1, 1), bits);
    }

    #[test]
    fn opening_takes_off_lines_and_leaves_squares_and_discs() {
        let mut bits = Bits::new(40, 30);
        for x in 0..40 {
            bits.on[10 * 40 + x] = true;
        }
        for (x, y) in (5..16).flat_map(|x| (5..16).map(move |y| (x, y))) {
            bits.on[y * 40 + x] = true;
        }
        assert_eq!(bits.opened_by_square(1).count(), 121);
        // By a disc the corners become round.
        let round = bits.opened(2.0).count();
        assert!((100..=121).contains(&round), "{round}");
        assert_eq!(bits.edges(), 4 * 11 - 2 + 2 * (40 - 11));
        // At the border nothing is eaten.
        let full = Bits { width: 4, height: 4, on: vec![true; 16] };
        assert_eq!((full.opened(3.0), full.opened_by_square(3)), (full.clone(), full.clone()));
    }
}
