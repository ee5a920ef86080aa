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
    #[inline(never)]
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
        sum_of(self.on.chunks(MOST_COUNTED).map(|part| part.iter().map(|&on| u8::from(on)).sum()))
    }

    /// How many neighbours above and beside each other differ.
    pub fn edges(&self) -> usize {
        let mut edges = 0;
        let mut above: Option<&[bool]> = None;
        for row in self.on.chunks_exact(self.width) {
            edges += differing(row, &row[1..]) + above.map_or(0, |above| differing(row, above));
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
        let radius = radius.min(MOST_NEAR as usize);
        let (mut line, mut next) = (Vec::new(), Vec::new());
        for row in self.on.chunks_exact_mut(self.width) {
            line.clear();
            line.resize(radius, false);
            line.extend(row.iter().map(|&on| on == to));
            line.resize(row.len() + 2 * radius, false);
            // Whether there is one among the next, twice as many each time: pixels side by side at once.
            let mut among = 1;
            while 2 * among <= 2 * radius + 1 {
                next.clear();
                next.extend(line.iter().zip(&line[among..]).map(|(a, b)| a | b));
                std::mem::swap(&mut line, &mut next);
                among *= 2;
            }
            let both = line.iter().zip(&line[2 * radius + 1 - among..]);
            row.iter_mut().zip(both).for_each(|(on, (a, b))| *on = (a | b) == to);
        }
        let far = self.rows_away(to, radius as u8 + 1);
        self.on.iter_mut().zip(far).for_each(|(on, far)| *on = (usize::from(far) <= radius) == to);
    }

    /// How many rows away the next pixel of each column is whose bit is `from`, `beyond` at most: row by row, as pixels
    /// lie in memory.
    #[inline(never)]
    fn rows_away(&self, from: bool, beyond: u8) -> Vec<u8> {
        let mut far = vec![beyond; self.on.len()];
        let mut last = vec![beyond; self.width];
        let rows = || self.on.chunks_exact(self.width);
        for (row, far) in rows().zip(far.chunks_exact_mut(self.width)) {
            step_away(row, from, beyond, &mut last, far);
        }
        last.fill(beyond);
        for (row, far) in rows().zip(far.chunks_exact_mut(self.width)).rev() {
            step_away(row, from, beyond, &mut last, far);
        }
        far
    }

    /// All pixels at most `radius` from one that is on.
    pub fn grown(&self, radius: f64) -> Self {
        self.within(true, radius)
    }

    /// The pixels that are more than `radius` from all that are off. Beyond the border all counts as on.
    pub fn shrunk(&self, radius: f64) -> Self {
        let mut left = self.within(false, radius);
        left.on.iter_mut().for_each(|on| *on = !*on);
        left
    }

    /// What a disc covers that stays within.
    pub fn opened(&self, radius: f64) -> Self {
        self.shrunk(radius).grown(radius)
    }

    fn where_distance(&self, from: bool, keep: impl Fn(f64) -> bool) -> Self {
        let on = squared_distances(self, from).iter().map(|&squared| keep(f64::from(squared))).collect();
        Self { width: self.width, height: self.height, on }
    }

    /// Which pixels are at most `radius` from one whose bit is `from`: in each column first, then along the rows, where
    /// a pixel reaches the less far the farther up or down it found one.
    fn within(&self, from: bool, radius: f64) -> Self {
        if !(0.0..MOST_NEAR).contains(&radius) {
            return self.where_distance(from, |squared| squared <= radius * radius);
        }
        let across = |down: usize| (radius * radius - (down * down) as f64).sqrt() as usize;
        let holds = |across: usize, down: usize| (across * across + down * down) as f64 <= radius * radius;
        // Rounding may have taken the root of a square to either side of it.
        let reach: Vec<u32> = (0..=radius as usize)
            .map(|down| (0..=across(down) + 1).rev().find(|&far| holds(far, down)).unwrap_or(0) as u32)
            .collect();
        let beyond = reach.len() as u8;
        let far = self.rows_away(from, beyond);
        let mut near = vec![false; self.on.len()];
        for (far, near) in far.chunks_exact(self.width).zip(near.chunks_exact_mut(self.width)) {
            let (least, most) = far.iter().fold((u8::MAX, 0), |(a, b), &far| (a.min(far), b.max(far)));
            if least == beyond {
                continue;
            }
            if most == 0 {
                near.fill(true);
                continue;
            }
            let ahead = |far: u8| reach.get(usize::from(far)).map_or(0, |reach| reach + 1);
            // How many more pixels are near, the one that is looked at among them: forwards, then back.
            let mut left = 0;
            for (&far, near) in far.iter().zip(near.iter_mut()) {
                left = ahead(far).max(left);
                *near = left > 0;
                left = left.saturating_sub(1);
            }
            left = 0;
            for (&far, near) in far.iter().zip(near).rev() {
                left = ahead(far).max(left);
                *near |= left > 0;
                left = left.saturating_sub(1);
            }
        }
        Self { width: self.width, height: self.height, on: near }
    }
}

/// So many are counted in a byte, many at once.
const MOST_COUNTED: usize = 255;

/// A radius below this is counted in bytes, too.
const MOST_NEAR: f64 = 250.0;

fn sum_of(parts: impl Iterator<Item = u8>) -> usize {
    parts.map(usize::from).sum()
}

/// At how many places two rows differ, as far as both go.
#[inline(never)]
fn differing(a: &[bool], b: &[bool]) -> usize {
    let parts = a.chunks(MOST_COUNTED).zip(b.chunks(MOST_COUNTED));
    sum_of(parts.map(|(a, b)| a.iter().zip(b).map(|(a, b)| u8::from(a != b)).sum()))
}

/// The first place from `start` on whose bit is `wanted`, if there is one.
#[inline(never)]
pub fn find(row: &[bool], start: usize, wanted: bool) -> Option<usize> {
    /// So many are looked at together.
    const TOGETHER: usize = 16;
    let rest = row.get(start..)?;
    let any = |part: &[bool]| part.iter().fold(false, |any, &bit| any | (bit == wanted));
    let skipped = TOGETHER * rest.chunks_exact(TOGETHER).take_while(|part| !any(part)).count();
    rest[skipped..].iter().position(|&bit| bit == wanted).map(|more| start + skipped + more)
}

/// Takes the next row, and notes how many rows ago each column had one that was `wanted`, where that is less than what
/// is known.
fn step_away(row: &[bool], wanted: bool, beyond: u8, last: &mut [u8], far: &mut [u8]) {
    for ((&on, last), far) in row.iter().zip(last).zip(far) {
        *last = if on == wanted { 0 } else { (*last + 1).min(beyond) };
        *far = (*far).min(*last);
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
    fn what_is_near_is_what_distances_say() {
        for seed in 0..12_u32 {
            let dense = [0.002, 0.02, 0.2, 0.9][seed as usize % 4];
            let (width, height) = [(61, 43), (1, 30), (30, 1), (80, 7)][seed as usize / 3];
            let is_on = |i: u32| frond_core::hash::unit(frond_core::hash::counter(seed, i)) < dense;
            let bits = Bits { width, height, on: (0..(width * height) as u32).map(is_on).collect() };
            // Roots of sums of two squares, and what lies between them.
            for radius in [0.0, 0.9, 1.0, 2.0_f64.sqrt(), 2.0, 5.0_f64.sqrt(), 5.0, 12.5, 40.0, 300.0] {
                for from in [false, true] {
                    let plain = bits.where_distance(from, |squared| squared <= radius * radius);
                    assert!(bits.within(from, radius) == plain, "{seed}, {radius}, {from}");
                }
            }
        }
    }

    #[test]
    fn a_square_fits_where_all_of_it_does() {
        for (seed, radius) in [(1, 1), (2, 2), (3, 3), (4, 4), (5, 7), (6, 30)] {
            let is_on = |i: u32| frond_core::hash::unit(frond_core::hash::counter(seed, i)) < 0.985;
            let bits = Bits { width: 37, height: 29, on: (0..37 * 29).map(is_on).collect() };
            let square = |x: i32, y: i32| {
                let reach = radius as i32;
                (-reach..=reach).flat_map(move |dy| (-reach..=reach).map(move |dx| (x + dx, y + dy)))
            };
            let inside = |x: i32, y: i32| (0..37).contains(&x) && (0..29).contains(&y);
            // Beyond the border all counts as on, but for squares whose middles are there.
            let fits = |x, y| {
                inside(x, y) && square(x, y).all(|(x, y)| !inside(x, y) || bits.on[(y * 37 + x) as usize])
            };
            let opened = bits.opened_by_square(radius);
            for (i, &on) in opened.on.iter().enumerate() {
                let covered = square(i as i32 % 37, i as i32 / 37).any(|(x, y)| fits(x, y));
                assert_eq!(on, covered, "radius {radius}, pixel {i}");
            }
        }
    }

    #[test]
    fn long_rows_are_counted_and_searched_as_short_ones() {
        let on: Vec<bool> = (0..3000).map(|i| i % 7 == 3 || (800..1400).contains(&i)).collect();
        let bits = Bits { width: 1000, height: 3, on };
        assert_eq!(bits.count(), bits.on.iter().filter(|&&on| on).count());
        let at = |x: usize, y: usize| bits.on[1000 * y + x];
        let beside = (0..3).flat_map(|y| (1..1000).map(move |x| at(x, y) != at(x - 1, y)));
        let above = (1..3).flat_map(|y| (0..1000).map(move |x| at(x, y) != at(x, y - 1)));
        assert_eq!(bits.edges(), beside.chain(above).filter(|&differs| differs).count());
        for wanted in [false, true] {
            for start in 0..=3000 {
                let first = (start..3000).find(|&i| bits.on[i] == wanted);
                assert_eq!(find(&bits.on, start, wanted), first, "from {start}");
            }
        }
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
