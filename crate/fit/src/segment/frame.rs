//! What surrounds a picture and is no part of it: a frame, a strip along a side, the dark around the round field of a
//! microscope, the clear margin of a card.
//!
//! Frames are even and begin at the border of the picture; what they leave open is a rectangle, straight or a little
//! turned, or a disc, which leaves are not. Whether there is a leaf inside is asked by whoever leaves the frame out.

mod fill;
mod round;
mod straight;

use super::binary_image::Bits;
use super::components::parts;
use super::notice::Surround;
use round::Disc;
use straight::Quad;

pub use fill::without;

/// Frames are looked for in a picture of at most so many pixels.
const MOST_PIXELS: usize = 250_000;

/// Colours of a side differ by so much, and by so many times more than half of them do from their middle.
const LEAST_TOLERANCE: u8 = 26;
const MOST_TOLERANCE: u8 = 60;

/// What a frame leaves open is at least this part of the picture.
const LEAST_FIELD: f64 = 0.25;

/// And all that lies in the frame, such as dust, at most this part of it.
const MOST_DUST: f64 = 0.1;

/// A frame is at least this part of the picture, but for clear corners.
const LEAST_FRAME: f64 = 0.002;

/// What surrounds a picture.
#[derive(Clone, Debug)]
pub struct Frame {
    pub kind: Surround,
    /// Whether what is inside is round, and may be a shape of its own.
    pub is_round: bool,
    /// Its pixels, and the edge to what is inside.
    pub around: Bits,
}

/// What is open in a frame.
enum Field {
    Straight(Quad),
    Round(Disc),
}

/// A picture made smaller: pixels of it at even distances, the first and the last of each side among them.
struct Sampled<'a> {
    width: usize,
    height: usize,
    pixels: Vec<[u8; 4]>,
    full: [usize; 2],
    rgba: &'a [u8],
}

impl<'a> Sampled<'a> {
    #[inline(never)]
    fn new(rgba: &'a [u8], width: usize, height: usize) -> Self {
        let factor = ((width * height) as f64 / MOST_PIXELS as f64).sqrt().max(1.0);
        let less = |side: usize| ((side as f64 / factor) as usize).clamp(1, side);
        let along =
            |at: usize, count: usize, full: usize| if count > 1 { at * (full - 1) / (count - 1) } else { 0 };
        let (across, down) = (less(width), less(height));
        let columns: Vec<usize> = (0..across).map(|x| 4 * along(x, across, width)).collect();
        let mut pixels = Vec::with_capacity(across * down);
        for y in 0..down {
            let row = &rgba[4 * along(y, down, height) * width..][..4 * width];
            pixels.extend(columns.iter().map(|&at| [row[at], row[at + 1], row[at + 2], row[at + 3]]));
        }
        Self { width: across, height: down, pixels, full: [width, height], rgba }
    }

    fn pixel(&self, i: usize) -> &[u8; 4] {
        &self.pixels[i]
    }

    /// How light each pixel is.
    fn light(&self) -> Vec<u8> {
        let light = |p: &[u8; 4]| ((u32::from(p[0]) + 2 * u32::from(p[1]) + u32::from(p[2])) / 4) as u8;
        self.pixels.iter().map(light).collect()
    }

    /// How many pixels of the picture are one here, across and down.
    fn scale(&self) -> [f64; 2] {
        let times = |count: usize, full: usize| (full.max(2) - 1) as f64 / (count.max(2) - 1) as f64;
        [times(self.width, self.full[0]), times(self.height, self.full[1])]
    }

    fn bits(&self, on: impl Fn(&[u8; 4]) -> bool) -> Bits {
        Bits { width: self.width, height: self.height, on: self.pixels.iter().map(on).collect() }
    }

    /// Even colours that the border may have, with how much each pixel may differ from it: of its sides and corners.
    #[inline(never)]
    fn colours(&self) -> Vec<([u8; 3], u8)> {
        let (width, height) = (self.width, self.height);
        let corner = (width.min(height) / 40).max(1);
        let block = |x0: usize, y0: usize, across: usize, down: usize| -> Vec<usize> {
            (y0..y0 + down).flat_map(|y| (x0..x0 + across).map(move |x| y * width + x)).collect()
        };
        let (right, bottom) = (width - corner, height - corner);
        let places = [
            block(0, 0, width, 1),
            block(0, height - 1, width, 1),
            block(0, 0, 1, height),
            block(width - 1, 0, 1, height),
            block(0, 0, corner, corner),
            block(right, 0, corner, corner),
            block(0, bottom, corner, corner),
            block(right, bottom, corner, corner),
        ];
        let mut found: Vec<([u8; 3], u8)> = Vec::new();
        for place in places {
            let colour: [u8; 3] =
                std::array::from_fn(|c| middle(place.iter().map(|&i| self.pixel(i)[c]).collect()));
            let off = |&i: &usize| apart(self.pixel(i), colour);
            let tolerance =
                middle(place.iter().map(off).collect()).saturating_mul(3).saturating_add(LEAST_TOLERANCE);
            if found.iter().all(|(known, _)| apart(&colour, *known) > 12) {
                found.push((colour, tolerance.min(MOST_TOLERANCE)));
            }
        }
        found
    }
}

fn middle(mut values: Vec<u8>) -> u8 {
    let at = values.len() / 2;
    *values.select_nth_unstable(at).1
}

/// The largest difference of a channel.
fn apart(pixel: &[u8], colour: [u8; 3]) -> u8 {
    pixel.iter().zip(colour).map(|(&a, b)| a.abs_diff(b)).max().unwrap_or(0)
}

/// What may be a frame: a clear margin, or clear corners around what is opaque, if that is a card and no shape; where
/// `coloured`, then one of one colour, the likeliest first.
#[inline(never)]
pub fn likely(rgba: &[u8], width: usize, height: usize, coloured: bool) -> Vec<Frame> {
    let small = Sampled::new(rgba, width, height);
    let clear = found(&small, &small.bits(|pixel| pixel[3] < 128), true);
    let near =
        |(colour, tolerance): ([u8; 3], u8)| small.bits(|pixel| apart(&pixel[..3], colour) <= tolerance);
    let colours = if coloured { small.colours() } else { Vec::new() };
    clear
        .into_iter()
        .chain(colours.into_iter().filter_map(|colour| found(&small, &near(colour), false)))
        .collect()
}

/// What hangs together with the border in `even` as a frame, if what it leaves open is a field.
#[inline(never)]
fn found(small: &Sampled<'_>, even: &Bits, clear: bool) -> Option<Frame> {
    let (width, height) = (small.width, small.height);
    if !even.on.contains(&true) {
        return None;
    }
    let pieces = parts(even, true, false);
    let frame = pieces.bits_where(width, height, |label| pieces.all[label].touches_border);
    let all = width * height;
    let open = all - frame.count();
    if (open as f64) < LEAST_FIELD * all as f64 || open == all {
        return None;
    }
    let field = parts(&frame, false, false).largest(1, 1);
    let area = field.all.first()?.area;
    if ((open - area) as f64) > MOST_DUST * (all - open) as f64 + 2.0
        || (area as f64) < LEAST_FIELD * all as f64
    {
        return None;
    }
    let field = field.bits(width, height);
    let model = Quad::around(&field)
        .map(Field::Straight)
        .or_else(|| Disc::around(&field).map(|disc| Field::Round(disc.lit(&small.light(), width))))?;
    let outside = |i: usize| match &model {
        Field::Straight(quad) => {
            quad.is_outside(i % width, i / width) || (quad.is_corner(i % width, i / width) && !field.on[i])
        }
        Field::Round(disc) => disc.is_outside(i % width, i / width),
    };
    let around = Bits { width, height, on: (0..all).map(outside).collect() };
    let corners = [0, width - 1, all - width, all - 1].iter().all(|&i| around.on[i]);
    let enough = if corners { 4 } else { ((LEAST_FRAME * all as f64) as usize).max(4) };
    if around.count() < enough {
        return None;
    }
    let kind = match &model {
        _ if clear => Surround::Clear,
        Field::Round(_) => Surround::Round,
        Field::Straight(_) if corners || [0, all - 1].iter().all(|&i| around.on[i]) => Surround::Frame,
        Field::Straight(_) => Surround::Strip,
    };
    let is_round = matches!(model, Field::Round(_));
    Some(Frame { kind, is_round, around: enlarged(&around, small, clear) })
}

/// A frame at full size, with the edge to what is inside.
#[inline(never)]
fn enlarged(around: &Bits, small: &Sampled<'_>, clear: bool) -> Bits {
    let [width, height] = small.full;
    let [across, down] = small.scale();
    let mut full = Bits::new(width, height);
    for (i, on) in full.on.iter_mut().enumerate() {
        let (x, y) = ((i % width) as f64 / across, (i / width) as f64 / down);
        let at = |value: f64, count: usize| (value.round() as usize).min(count - 1);
        *on = around.on[at(y, around.height) * around.width + at(x, around.width)]
            || (clear && small.rgba[4 * i + 3] < 128);
    }
    full.grown(across.max(down) + 1.5)
}
