//! What of a pixel's colour tells the leaf from what lies around it.

/// One number a pixel, 0 to 255.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Channel {
    /// How solid it is.
    Alpha,
    /// How light it is.
    Light,
    /// How much red is in it: leaves have little, and red rules as much as white paper.
    Red,
    /// How much green.
    Green,
    /// How much blue.
    Blue,
    /// How far its colours lie apart: 0 for grey.
    Saturation,
    /// How much more green than other colours.
    Greenness,
    /// How far it is from the colour around the picture's border, shade counting less than hue.
    Colour,
}

impl Channel {
    /// All but [`Alpha`](Self::Alpha), the plainest first.
    pub const OF_COLOUR: [Self; 7] =
        [Self::Light, Self::Red, Self::Blue, Self::Green, Self::Saturation, Self::Greenness, Self::Colour];

    /// A name that does not change, for programs.
    #[must_use]
    pub const fn code(self) -> &'static str {
        match self {
            Self::Alpha => "alpha",
            Self::Light => "light",
            Self::Red => "red",
            Self::Green => "green",
            Self::Blue => "blue",
            Self::Saturation => "saturation",
            Self::Greenness => "greenness",
            Self::Colour => "colour",
        }
    }

    /// Its value in each pixel. `around` is the colour that [`Colour`](Self::Colour) is measured from.
    pub(super) fn values(self, rgba: &[u8], around: [u8; 3]) -> Vec<u8> {
        if self == Self::Alpha {
            return rgba.chunks_exact(4).map(|pixel| pixel[3]).collect();
        }
        let mut values = Vec::with_capacity(rgba.len() / 4);
        in_planes(rgba, &mut |planes| self.read(planes, around, &mut values));
        values
    }

    /// How often each value comes, for all of [`OF_COLOUR`](Self::OF_COLOUR): the picture is gone through once.
    #[inline(never)]
    pub(super) fn histograms(rgba: &[u8], around: [u8; 3]) -> [[u64; 256]; 7] {
        let mut all = [[0; 256]; 7];
        let mut values = Vec::new();
        in_planes(rgba, &mut |planes| {
            for (channel, counts) in Self::OF_COLOUR.into_iter().zip(&mut all) {
                values.clear();
                channel.read(planes, around, &mut values);
                super::otsu::count(&values, counts);
            }
        });
        all
    }

    /// Adds its values, of which each has its red, green and blue: a loop for each channel, of many pixels at once.
    fn read(self, planes: &[Vec<u8>; 3], around: [u8; 3], out: &mut Vec<u8>) {
        let [red, green, blue] = planes;
        match self {
            Self::Alpha => {}
            Self::Light => extend(out, planes, |r, g, b| {
                ((77 * u16::from(r) + 150 * u16::from(g) + 29 * u16::from(b) + 128) >> 8) as u8
            }),
            Self::Red => out.extend_from_slice(red),
            Self::Green => out.extend_from_slice(green),
            Self::Blue => out.extend_from_slice(blue),
            Self::Saturation => extend(out, planes, |r, g, b| r.max(g).max(b) - r.min(g).min(b)),
            Self::Greenness => extend(out, planes, |r, g, b| {
                let [red, green, blue] = [r, g, b].map(i16::from);
                (128 + green - (red + blue) / 2).clamp(0, 255) as u8
            }),
            Self::Colour => {
                let paper = Opponent::of(around);
                extend(out, planes, |r, g, b| Opponent::of([r, g, b]).distance(paper));
            }
        }
    }
}

/// Calls with the red, green and blue of pixel after pixel, as many together as stay in the processor.
fn in_planes(rgba: &[u8], act: &mut dyn FnMut(&[Vec<u8>; 3])) {
    const TOGETHER: usize = 1 << 13;
    let mut planes = [const { Vec::new() }; 3];
    for part in rgba.chunks(4 * TOGETHER) {
        for (k, plane) in planes.iter_mut().enumerate() {
            plane.clear();
            plane.extend(part.chunks_exact(4).map(|pixel| pixel[k]));
        }
        act(&planes);
    }
}

fn extend(out: &mut Vec<u8>, [red, green, blue]: &[Vec<u8>; 3], value: impl Fn(u8, u8, u8) -> u8) {
    out.extend(red.iter().zip(green).zip(blue).map(|((&r, &g), &b)| value(r, g, b)));
}

/// A colour as its light and two differences of colours.
#[derive(Clone, Copy)]
struct Opponent {
    light: f32,
    yellow: f32,
    red: f32,
}

impl Opponent {
    fn of(rgb: [u8; 3]) -> Self {
        let [r, g, b] = rgb.map(f32::from);
        let light = 0.299 * r + 0.587 * g + 0.114 * b;
        Self { light, yellow: 0.564 * (b - light), red: 0.713 * (r - light) }
    }

    fn distance(self, other: Self) -> u8 {
        let shade = 0.5 * (self.light - other.light);
        let (yellow, red) = (self.yellow - other.yellow, self.red - other.red);
        let hue_squared = yellow * yellow + red * red;
        // 255 at most: what is farther is far enough.
        ((shade * shade + 1.6 * 1.6 * hue_squared).sqrt() + 0.5) as u8
    }
}

/// The middle colour along the border of a picture, by channels.
#[inline(never)]
pub(super) fn border_colour(rgba: &[u8], width: usize, height: usize) -> [u8; 3] {
    let mut counts = [[0_u64; 256]; 3];
    for i in border(width, height) {
        for (counts, &value) in counts.iter_mut().zip(&rgba[4 * i..4 * i + 3]) {
            counts[usize::from(value)] += 1;
        }
    }
    counts.map(|counts| super::otsu::quantile(&counts, 0.5))
}

/// The indices of the pixels along the border: a 50th of the shorter side, one pixel at least.
pub(super) fn border(width: usize, height: usize) -> impl Iterator<Item = usize> {
    let band = (width.min(height) / 50).max(1);
    (0..height).flat_map(move |y| {
        let whole = y < band || y + band >= height;
        let left = 0..if whole { width } else { band.min(width) };
        let right = if whole { width } else { width.saturating_sub(band).max(band) }..width;
        left.chain(right).map(move |x| y * width + x)
    })
}

/// Each value averaged with its eight neighbours, the near ones more.
#[inline(never)]
pub(super) fn blur(values: &[u8], width: usize) -> Vec<u8> {
    let mut rows = vec![0_u16; values.len()];
    for (row, sums) in values.chunks_exact(width.max(1)).zip(rows.chunks_exact_mut(width.max(1))) {
        let at = |x: usize| u16::from(row[x.min(width - 1)]);
        sums[0] = 3 * at(0) + at(1);
        sums[width - 1] = at(width.saturating_sub(2)) + 3 * at(width - 1);
        for (near, sum) in row.windows(3).zip(&mut sums[1..]) {
            *sum = u16::from(near[0]) + 2 * u16::from(near[1]) + u16::from(near[2]);
        }
    }
    let height = values.len() / width.max(1);
    let row = |y: usize| &rows[y * width..(y + 1) * width];
    let mut out = Vec::with_capacity(values.len());
    for y in 0..height {
        let (above, here, below) = (row(y.saturating_sub(1)), row(y), row((y + 1).min(height - 1)));
        out.extend(above.iter().zip(here).zip(below).map(|((a, b), c)| ((a + 2 * b + c + 8) >> 4) as u8));
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_border_is_counted_once() {
        for (width, height) in [(1, 1), (1, 9), (5, 1), (2, 2), (3, 3), (120, 110)] {
            let mut all: Vec<_> = border(width, height).collect();
            let count = all.len();
            all.sort_unstable();
            all.dedup();
            assert_eq!(all.len(), count, "{width} x {height}");
            assert!(all.iter().all(|&i| i < width * height));
        }
        assert_eq!(border(120, 110).count(), 120 * 110 - 116 * 106);
    }

    #[test]
    fn channels_tell_colours() {
        let rgba = [40, 120, 30, 255, 250, 240, 235, 255, 230, 120, 110, 9];
        let of = |channel: Channel| channel.values(&rgba, [250, 240, 235]);
        assert_eq!(of(Channel::Alpha), [255, 255, 9]);
        assert_eq!(of(Channel::Red), [40, 250, 230]);
        assert_eq!(of(Channel::Saturation), [90, 15, 120]);
        assert_eq!(of(Channel::Greenness), [213, 126, 78]);
        let colour = of(Channel::Colour);
        for (channel, counts) in Channel::OF_COLOUR.iter().zip(Channel::histograms(&rgba, [250, 240, 235])) {
            let counted = |value: usize| of(*channel).iter().filter(|&&v| usize::from(v) == value).count();
            assert!((0..256).all(|value| counts[value] == counted(value) as u64), "{channel:?}");
        }
        assert!(colour[1] == 0 && colour[0] > 60 && colour[2] > 60, "{colour:?}");
    }

    #[test]
    fn blur_keeps_what_is_even_and_spreads_a_point() {
        assert_eq!(blur(&[7; 12], 4), [7; 12]);
        let mut point = vec![0; 25];
        point[12] = 160;
        assert_eq!(blur(&point, 5)[11..14], [20, 40, 20]);
        assert_eq!(blur(&[9], 1), [9]);
    }
}
