//! From a picture to an outline: a mask that is found by itself and can be mended, and the line round a piece of it.

mod binary_image;
mod channel;
mod components;
mod contour;
mod morphology;
mod notice;
mod otsu;
mod stroke;
mod threshold;

pub use channel::Channel;
pub use components::Component;
pub use notice::{Notice, TraceError};
pub use stroke::Stroke;

use glam::DVec2;

use binary_image::Bits;
use components::{Parts, fill_holes, parts};
use contour::{Field, area};
use morphology::{close_slits, drop_thin, remove_stalks};
use otsu::{histogram, quantile};
use threshold::{Choice, choose};

use crate::outline::{MAX_OUTLINE, thinned};

/// The most pixels that are worked on: some 100 MiB are needed meanwhile.
pub const MAX_PIXELS: usize = 1 << 22;

/// The most pieces of a mask.
const MAX_PIECES: usize = 64;

/// Classes nearer than this to each other are taken for one colour, in grey values.
const LEAST_CONTRAST: f64 = 14.0;

/// How a mask is to be drawn.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MaskOptions {
    /// -1 to 1: less or more of the picture is taken for the leaf than was found by itself, which is 0.
    pub threshold: f64,
    /// Whether the leaf is what the ground was taken for.
    pub invert: bool,
    /// Whether stalks are taken off.
    pub remove_stalks: bool,
    /// Strokes of the brush, the first one first. They hold whatever the threshold is.
    pub strokes: Vec<Stroke>,
}

/// What of a picture is leaf, and in which pieces.
#[derive(Clone, Debug)]
pub struct Mask {
    width: usize,
    height: usize,
    labels: Vec<u32>,
    components: Vec<Component>,
    notices: Vec<Notice>,
    level: f64,
    inverted: bool,
}

/// The line round a piece.
#[derive(Clone, Debug, PartialEq)]
pub struct Traced {
    /// Counter-clockwise, closed, the first not repeated; in pixels, y up, from the lower left corner of the picture.
    /// At most [`MAX_OUTLINE`].
    pub points: Vec<DVec2>,
    /// What may be amiss.
    pub notices: Vec<Notice>,
}

impl Traced {
    /// The area inside, in pixels.
    #[must_use]
    pub fn area(&self) -> f64 {
        let Some(&first) = self.points.first() else { return 0.0 };
        self.sides().map(|(a, b)| (a - first).perp_dot(b - first)).sum::<f64>() / 2.0
    }

    /// The length all round, in pixels.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.sides().map(|(a, b)| a.distance(b)).sum()
    }

    fn sides(&self) -> impl Iterator<Item = (DVec2, DVec2)> {
        self.points.iter().copied().zip(self.points.iter().copied().cycle().skip(1))
    }
}

/// Traces one picture.
///
/// Which of several channels is looked at, and where the line in it is drawn, is found once, from the picture: whether
/// the leaf is darker or lighter than its ground or cut out of it, and whether there are rules on the ground.
#[derive(Clone, Debug)]
pub struct Tracer {
    width: usize,
    height: usize,
    choice: Option<Choice>,
    dark: bool,
    /// The values that all but a 200th lie between.
    range: (f64, f64),
}

impl Tracer {
    /// Looks at a picture: red, green, blue and alpha (not multiplied) of each pixel, row after row from the top.
    ///
    /// # Errors
    /// Where a side is 0, there are more than [`MAX_PIXELS`] pixels, or not four bytes for each.
    pub fn new(width: usize, height: usize, rgba: &[u8]) -> Result<Self, TraceError> {
        if width == 0 || height == 0 {
            return Err(TraceError::NoPixels);
        }
        if width.checked_mul(height).is_none_or(|pixels| pixels > MAX_PIXELS) {
            return Err(TraceError::TooLarge { width, height });
        }
        if rgba.len() != 4 * width * height {
            return Err(TraceError::WrongLength { width, height, bytes: rgba.len() });
        }
        let choice = choose(rgba, width, height);
        let light =
            rgba.chunks_exact(4).map(|p| p[..3].iter().map(|&v| u64::from(v)).sum::<u64>()).sum::<u64>();
        let range = choice.as_ref().map_or((0.0, 255.0), |choice| {
            let counts = histogram(&choice.likeness);
            (f64::from(quantile(&counts, 0.005)), f64::from(quantile(&counts, 0.995)))
        });
        Ok(Self { width, height, choice, dark: light < 3 * 40 * (width * height) as u64, range })
    }

    /// The channel that tells the leaf from its ground, if any does.
    #[must_use]
    pub fn channel(&self) -> Option<Channel> {
        self.choice.as_ref().map(|choice| choice.channel)
    }

    /// Whether anything stands out.
    fn stands_out(&self) -> Option<&Choice> {
        self.choice.as_ref().filter(|choice| choice.contrast >= LEAST_CONTRAST)
    }

    /// The mask for a threshold, with its pieces.
    #[must_use]
    pub fn mask(&self, options: &MaskOptions) -> Mask {
        let offset = if options.threshold.is_nan() { 0.0 } else { options.threshold.clamp(-1.0, 1.0) };
        let (mut bits, level) = match &self.choice {
            // Where nothing stands out, it is only looked for when that is asked for.
            Some(choice) if offset != 0.0 || options.invert || self.stands_out().is_some() => {
                self.find(choice, offset, options)
            }
            _ => (Bits::new(self.width, self.height), 127.5),
        };
        let away = stroke::paint(&mut bits, &options.strokes);
        let most = parts(&bits, true, true).largest(1, 1).all.first().map_or(0, |part| part.area / 20);
        fill_holes(&mut bits, most, |i| away[i]);
        let Parts { labels, all } = parts(&bits, true, true).largest(2, MAX_PIECES);
        let notices = self.notices(&all);
        Mask {
            width: self.width,
            height: self.height,
            labels,
            components: all,
            notices,
            level,
            inverted: options.invert,
        }
    }

    /// What is found without a brush.
    fn find(&self, choice: &Choice, offset: f64, options: &MaskOptions) -> (Bits, f64) {
        let (low, high) = self.range;
        let middle = choice.level.level;
        let level = if offset > 0.0 {
            middle - offset * (middle - low + 1.0)
        } else {
            middle - offset * (high - middle + 1.0)
        };
        let mut bits = Bits::above(&choice.likeness, self.width, self.height, level);
        if options.invert {
            bits.on.iter_mut().for_each(|on| *on = !*on);
        }
        if choice.rules > 0 && !options.invert {
            // Without rules, then again what lies close to what is left: teeth are thin, too.
            let wide = bits.opened_by_square(choice.rules).grown(choice.rules as f64 + 1.5);
            bits.on.iter_mut().zip(&wide.on).for_each(|(on, &wide)| *on &= wide);
        }
        let found = parts(&bits, true, true);
        let area = found.all.iter().map(|part| part.area).max().unwrap_or(0);
        if area == 0 {
            return (bits, level);
        }
        let size = (area as f64).sqrt();
        let gap = (0.02 * size).clamp(1.5, 40.0);
        // From here on only what surrounds pieces of some size is looked at.
        let [left, top, right, bottom] = self.around(&found.all, area / 200, gap as usize + 3);
        let mut bits = bits.cut([left, top, right, bottom]);
        if choice.channel != Channel::Alpha && !options.invert {
            let weak = level - 0.35 * (level - choice.level.dark).max(0.0);
            let rows = (top..bottom).map(|y| &choice.likeness[y * self.width + left..y * self.width + right]);
            close_slits(&mut bits, &rows.flatten().copied().collect::<Vec<_>>(), weak, gap);
        }
        if options.remove_stalks {
            remove_stalks(&mut bits, size);
        }
        // Specks: what is small by itself and beside the largest.
        let pieces = parts(&bits, true, true);
        let largest = pieces.all.iter().map(|part| part.area).max().unwrap_or(0);
        let mut bits = pieces.largest((largest / 50).max(12), MAX_PIECES).bits(bits.width, bits.height);
        drop_thin(&mut bits, ((0.008 * size) as usize).max(1));
        (bits.placed(self.width, self.height, left, top), level)
    }

    /// A box round all pieces of at least an area, and so many pixels more.
    fn around(&self, all: &[Component], least: usize, more: usize) -> [usize; 4] {
        let join = |[a, b, c, d]: [usize; 4], part: &Component| {
            let [left, top, right, bottom] = part.bounds;
            [a.min(left), b.min(top), c.max(right), d.max(bottom)]
        };
        let pieces = all.iter().filter(|part| part.area >= least);
        let [left, top, right, bottom] = pieces.fold([self.width, self.height, 0, 0], join);
        let (right, bottom) = ((right + more).min(self.width), (bottom + more).min(self.height));
        [left.saturating_sub(more), top.saturating_sub(more), right, bottom]
    }

    fn notices(&self, all: &[Component]) -> Vec<Notice> {
        let mut notices = Vec::new();
        match &self.choice {
            Some(choice) if choice.contrast >= LEAST_CONTRAST => {
                let speck = all.first().is_some_and(|first| 2000 * first.area < self.width * self.height);
                if choice.is_noise() || (all.len() > 1 && speck) {
                    notices.push(Notice::Noise);
                }
            }
            _ => notices.push(if self.dark { Notice::AllBlack } else { Notice::Blank }),
        }
        if let Some(first) = all.first() {
            let like = all.iter().filter(|part| 5 * part.area >= first.area).count();
            if like > 1 {
                notices.push(Notice::Several(like));
            }
        } else if notices.is_empty() {
            notices.push(Notice::Blank);
        }
        notices
    }

    /// The line round a piece of a mask of this picture, at a fraction of a pixel: where the likeness to the leaf
    /// crosses the mask's level, and between pixels where the mask was mended.
    ///
    /// # Errors
    /// Where there is no such piece, or it is too small.
    pub fn outline(&self, mask: &Mask, component: usize) -> Result<Traced, TraceError> {
        let count = mask.components.len();
        let Some(part) = mask.components.get(component) else { return Err(TraceError::NoPiece { count }) };
        if (mask.width, mask.height) != (self.width, self.height) {
            return Err(TraceError::NoPiece { count: 0 });
        }
        let [left, top, right, bottom] = part.bounds;
        // Two pixels round it: smoothing pushes the line out by less.
        let (left, top) = (left.saturating_sub(2), top.saturating_sub(2));
        let (right, bottom) = ((right + 2).min(self.width), (bottom + 2).min(self.height));
        let mut filled = Bits::new(right - left, bottom - top);
        for (y, row) in filled.on.chunks_exact_mut(right - left).enumerate() {
            let start = (top + y) * self.width + left;
            for (on, &label) in row.iter_mut().zip(&mask.labels[start..]) {
                *on = label == component as u32;
            }
        }
        let values = (0..filled.on.len()).map(|i| {
            let (x, y) = (left + i % filled.width, top + i / filled.width);
            self.inside(mask, filled.on[i], y * self.width + x)
        });
        let field = Field {
            width: filled.width,
            height: filled.height,
            values: smooth(&values.collect::<Vec<_>>(), filled.width),
        };
        let (x0, y0) = (left as f64, (self.height - top) as f64);
        let mut points: Vec<DVec2> = field.contour().iter().map(|p| DVec2::new(x0 + p.x, y0 - p.y)).collect();
        // Marching goes clockwise.
        points.reverse();
        points.dedup_by(|a, b| a.distance_squared(*b) < 1e-12);
        if points.len() < 4 || area(&points) < 1.0 {
            return Err(TraceError::TooSmall);
        }
        let mut notices = Vec::new();
        if part.touches_border {
            notices.push(Notice::TouchesBorder);
        }
        if points.len() > MAX_OUTLINE {
            notices.push(Notice::Thinned(points.len()));
            points = thinned(&points, MAX_OUTLINE);
        }
        Ok(Traced { points, notices })
    }

    /// How far inside a pixel is, -1 to 1.
    fn inside(&self, mask: &Mask, on: bool, i: usize) -> f32 {
        let Some(choice) = self.stands_out() else { return if on { 0.5 } else { -0.5 } };
        let soft = {
            let value = f64::from(choice.likeness[i]) - mask.level;
            // From the middle to either class: there an edge that is cut by a pixel is straight.
            let half =
                if value > 0.0 { choice.level.bright - mask.level } else { mask.level - choice.level.dark };
            let inside = (value / half.max(4.0)).clamp(-1.0, 1.0);
            if mask.inverted { -inside } else { inside }
        };
        match (on, soft > 0.0) {
            (true, true) | (false, false) => soft as f32,
            (true, false) => 0.5,
            (false, true) => -0.5,
        }
    }
}

/// Each value averaged with its neighbours: 1, 2, 1 across and down.
fn smooth(values: &[f32], width: usize) -> Vec<f32> {
    let height = values.len() / width.max(1);
    let row = |x: usize, y: usize| {
        let at = |x: usize| values[y * width + x];
        at(x.saturating_sub(1)) + 2.0 * at(x) + at((x + 1).min(width - 1))
    };
    let across: Vec<f32> = (0..values.len()).map(|i| row(i % width, i / width)).collect();
    let column = |x: usize, y: usize| {
        let at = |y: usize| across[y * width + x];
        (at(y.saturating_sub(1)) + 2.0 * at(y) + at((y + 1).min(height - 1))) / 16.0
    };
    (0..values.len()).map(|i| column(i % width, i / width)).collect()
}

impl Mask {
    /// Pixels across and down.
    #[must_use]
    pub fn size(&self) -> (usize, usize) {
        (self.width, self.height)
    }

    /// 255 inside and 0 outside, row after row from the top.
    #[must_use]
    pub fn bytes(&self) -> Vec<u8> {
        self.labels.iter().map(|&label| if label == components::NONE { 0 } else { 255 }).collect()
    }

    /// Its pieces, the largest first.
    #[must_use]
    pub fn components(&self) -> &[Component] {
        &self.components
    }

    /// What may be amiss.
    #[must_use]
    pub fn notices(&self) -> &[Notice] {
        &self.notices
    }

    /// How much like the leaf a pixel must be, in 0 to 255.
    #[must_use]
    pub fn level(&self) -> f64 {
        self.level
    }
}
