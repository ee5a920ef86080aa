//! The outlines of a file as they are found: the largest are kept, of the others their number, so that a file of a
//! million outlines takes no more memory than one of a hundred.

use glam::DVec2;

use super::content::{FileContent, NamedOutline};
use super::problem::{ReadError, Remark};
use crate::outline::{MAX_OUTLINE, Outline, crossings, thinned};

/// Points of one line are kept up to so many; of more, every second one, and so on.
pub const MAX_KEPT: usize = 1 << 20;
/// The most outlines that are listed.
const MAX_LISTED: usize = 100;
/// The most points of all that are listed, but for the largest outline.
const MAX_POINTS: usize = 20 * MAX_OUTLINE;
/// The most crossings that are counted.
const MAX_CROSSINGS: usize = 100;
/// Outlines and series have as many points at least.
pub const FEWEST_POINTS: usize = 3;

/// The points of a line, as they come.
#[derive(Default)]
pub struct Line {
    kept: Vec<DVec2>,
    /// How many came.
    pub count: usize,
    /// Every so many-th is kept, as a power of two.
    thin: u32,
    last: DVec2,
}

impl Line {
    pub fn push(&mut self, point: DVec2) {
        if self.count.trailing_zeros() >= self.thin {
            if self.kept.len() == MAX_KEPT {
                let mut k = 0;
                self.kept.retain(|_| (k % 2 == 0, k += 1).0);
                self.thin += 1;
            }
            if self.count.trailing_zeros() >= self.thin {
                self.kept.push(point);
            }
        }
        (self.count, self.last) = (self.count + 1, point);
    }

    /// Forgets all points, and keeps their room.
    pub fn clear(&mut self) {
        self.kept.clear();
        (self.count, self.thin) = (0, 0);
    }

    /// Whether it ends where it begins.
    pub fn returns(&self) -> bool {
        self.kept.first() == Some(&self.last)
    }

    /// Whether a point is its last one.
    pub fn ends_at(&self, point: DVec2) -> bool {
        self.count > 0 && self.last == point
    }

    /// Of how many points one was kept.
    pub fn stride(&self) -> usize {
        1 << self.thin
    }

    pub fn points(&self) -> &[DVec2] {
        &self.kept
    }

    pub fn into_points(self) -> Vec<DVec2> {
        self.kept
    }
}

/// What is said of a line.
pub struct About<L> {
    pub label: L,
    pub closed: bool,
    /// Whether it is what others are drawn on.
    pub ground: bool,
}

/// An outline that is among the largest so far.
pub struct Kept<L> {
    ground: bool,
    size: f64,
    pub label: L,
    pub outline: Outline,
}

/// The largest outlines so far, and what is to be said of all.
pub struct Gathered<L> {
    pub kept: Vec<Kept<L>>,
    points: usize,
    good: usize,
    opened: usize,
    /// How many points the last line had that was thinned.
    thinned: Option<usize>,
    error: Option<ReadError>,
}

impl<L> Default for Gathered<L> {
    fn default() -> Self {
        Self { kept: Vec::new(), points: 0, good: 0, opened: 0, thinned: None, error: None }
    }
}

impl<L> Gathered<L> {
    /// Takes a line, if it makes an outline.
    pub fn take(&mut self, line: &Line, about: About<L>) {
        let all = line.count;
        let fewer;
        let mut points = line.points();
        if points.len() > MAX_OUTLINE {
            self.thinned = Some(all);
            fewer = thinned(points, MAX_OUTLINE);
            points = &fewer;
        }
        let error = match Outline::new(points) {
            Ok(outline) => {
                self.good += 1;
                self.opened += usize::from(!about.closed);
                // What crosses itself may have no area: its box has.
                let (low, high) = outline.bounds();
                let size = outline.area().max(1e-3 * (high - low).element_product());
                self.points += outline.points().len();
                self.kept.push(Kept { ground: about.ground, size, label: about.label, outline });
                return self.prune();
            }
            Err(_) if all < FEWEST_POINTS => ReadError::TooFew { count: all, series: false },
            Err(_) => ReadError::Flat,
        };
        self.error.get_or_insert(error);
    }

    /// Takes all that others have gathered, as if it came later.
    pub fn absorb(&mut self, other: Self) {
        self.good += other.good;
        self.opened += other.opened;
        self.points += other.points;
        self.thinned = other.thinned.or(self.thinned);
        self.error = self.error.take().or(other.error);
        self.kept.extend(other.kept);
        self.prune();
    }

    /// Changes the points of all outlines so far. What has none any more is left out.
    pub fn change(&mut self, to: impl Fn(DVec2) -> DVec2) {
        self.kept.retain_mut(|kept| {
            let points: Vec<DVec2> = kept.outline.points().iter().map(|&p| to(p)).collect();
            Outline::new(&points).map(|outline| kept.outline = outline).is_ok()
        });
    }

    /// Turns outlines of pictures upright, where y goes down.
    pub fn mirror(&mut self) {
        self.change(|p| DVec2::new(p.x, -p.y));
    }

    /// Takes all lines so far for closed ones.
    pub fn close(&mut self) {
        self.opened = 0;
    }

    fn sort(&mut self) {
        self.kept.sort_by(|a, b| a.ground.cmp(&b.ground).then(b.size.total_cmp(&a.size)));
    }

    /// Drops the smallest ones once there are too many.
    fn prune(&mut self) {
        if self.kept.len() < 2 * MAX_LISTED && self.points <= MAX_POINTS {
            return;
        }
        self.sort();
        while self.kept.len() > MAX_LISTED || (self.points > MAX_POINTS && self.kept.len() > 1) {
            self.points -= self.kept.pop().map_or(0, |kept| kept.outline.points().len());
        }
    }

    /// The list, with a name for each.
    pub fn finish(
        mut self,
        format: &'static str,
        mut remarks: Vec<Remark>,
        name: impl Fn(&L) -> String,
    ) -> Result<FileContent, ReadError> {
        if self.kept.is_empty() {
            let nothing = match format {
                "geojson" => ReadError::Nothing { format: "JSON" },
                "svg" => ReadError::Nothing { format: "SVG" },
                _ => ReadError::TooFew { count: 0, series: false },
            };
            return Err(self.error.unwrap_or(nothing));
        }
        self.sort();
        self.kept.truncate(MAX_LISTED);
        if let Some(all) = self.thinned {
            remarks.retain(|remark| remark.code != "thinned");
            remarks.push(fewer(all));
        }
        if self.good > self.kept.len() {
            let message = match self.kept.len() {
                1 => format!("There are {} outlines: the largest is listed.", self.good),
                listed => format!("There are {} outlines: the {listed} largest are listed.", self.good),
            };
            remarks.push(Remark::new("ignored", message));
        }
        if self.opened > 0 {
            let message = match self.opened {
                1 => "A line that was open was closed by a straight side.".into(),
                count => format!("{count} lines that were open were closed by straight sides."),
            };
            remarks.push(Remark::new("closed", message));
        }
        let mut looked_at = 0;
        let outlines: Vec<NamedOutline> = self
            .kept
            .into_iter()
            .map(|Kept { label, outline, .. }| {
                looked_at += outline.points().len();
                let few = looked_at <= 5 * MAX_OUTLINE;
                let found = if few { crossings(outline.points(), MAX_CROSSINGS) } else { None };
                NamedOutline { name: name(&label), outline, crossings: found.map(|found| found.len()) }
            })
            .collect();
        if let Some(count) = outlines.first().and_then(|first| first.crossings).filter(|&count| count > 0) {
            let more = if count >= MAX_CROSSINGS { " or more" } else { "" };
            let message = format!(
                "The outline crosses itself {count} times{more}. It can be fitted, but inside and outside are not told \
                 apart there: mend it, or pick another."
            );
            remarks.push(Remark::new("crossing", message));
        }
        Ok(FileContent::Outlines { format, outlines, remarks })
    }
}

/// Word of points that are left out.
pub fn fewer(all: usize) -> Remark {
    Remark::new(
        "thinned",
        format!("There are {all} points, more than are needed: {MAX_OUTLINE} of them are kept."),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_of_any_length_is_kept_evenly() {
        for count in [0, 5, MAX_KEPT, MAX_KEPT + 1, 3 * MAX_KEPT + 7] {
            let mut line = Line::default();
            (0..count).for_each(|i| line.push(DVec2::splat(i as f64)));
            assert_eq!(line.count, count);
            assert!(line.points().len() <= MAX_KEPT && line.points().len() >= count.min(MAX_KEPT / 2));
            let stride = line.stride() as f64;
            assert!(line.points().windows(2).all(|pair| pair[1].x - pair[0].x == stride));
        }
    }

    #[test]
    fn the_largest_are_kept_whatever_comes_before_or_after() {
        let mut gathered = Gathered::default();
        let mut line = Line::default();
        for k in 0..1000_usize {
            let side = 1.0 + (k * 7919 % 1000) as f64;
            line.clear();
            for corner in [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]] {
                line.push(DVec2::from(corner) * side);
            }
            gathered.take(&line, About { label: side, closed: true, ground: k == 500 });
            assert!(gathered.kept.len() <= 2 * MAX_LISTED);
        }
        let content = gathered.finish("svg", Vec::new(), ToString::to_string).expect("outlines");
        let FileContent::Outlines { outlines, remarks, .. } = content else { panic!("outlines") };
        // 501 was the ground of the others, and it is not the only one.
        let wanted: Vec<String> = (901..=1000).rev().map(|side| side.to_string()).collect();
        assert_eq!(outlines.iter().map(|one| one.name.clone()).collect::<Vec<_>>(), wanted);
        assert_eq!(remarks[0].message, "There are 1000 outlines: the 100 largest are listed.");
    }
}
