//! The edge of a cut that was made at working size, at the size of the picture.

use super::oklab::Linear;
use super::working_picture::WorkingPicture;

/// How far around a place leaf and ground are looked at for their colours there, in pixels of the working size.
const AROUND: usize = 4;

/// Where leaf and ground differ by so much of the light, their colours count as much as what was cut before.
const TELLING: f32 = 0.02;

/// A plane of numbers at working size, between whose pixels it is straight.
struct Plane<'a> {
    picture: &'a WorkingPicture,
    values: Vec<f32>,
}

impl Plane<'_> {
    /// Where it is read for a pixel of the picture: the four pixels around and their shares.
    fn places(picture: &WorkingPicture, x: usize, y: usize) -> [(usize, f32); 4] {
        let place = |at: usize, most: usize| {
            let z = ((at as f32 + 0.5) / picture.factor as f32 - 0.5).clamp(0.0, most as f32 - 1.0);
            let low = z as usize;
            (low, (low + 1).min(most - 1), z - low as f32)
        };
        let (left, right, along) = place(x, picture.width);
        let (top, bottom, down) = place(y, picture.height);
        let at = |x: usize, y: usize| y * picture.width + x;
        [
            (at(left, top), (1.0 - along) * (1.0 - down)),
            (at(right, top), along * (1.0 - down)),
            (at(left, bottom), (1.0 - along) * down),
            (at(right, bottom), along * down),
        ]
    }

    /// The sum of each pixel's surroundings.
    fn around(&self) -> Self {
        let (width, height) = (self.picture.width, self.picture.height);
        let mut sums = self.values.clone();
        let mut line = Vec::new();
        for row in sums.chunks_exact_mut(width) {
            line.clear();
            line.extend_from_slice(row);
            sum_along(&line, |x, sum| row[x] = sum);
        }
        for x in 0..width {
            line.clear();
            line.extend((0..height).map(|y| sums[y * width + x]));
            sum_along(&line, |y, sum| sums[y * width + x] = sum);
        }
        Self { picture: self.picture, values: sums }
    }
}

fn sum_along(line: &[f32], mut put: impl FnMut(usize, f32)) {
    for i in 0..line.len() {
        put(i, line[i.saturating_sub(AROUND)..(i + AROUND + 1).min(line.len())].iter().sum());
    }
}

/// How much of each pixel of the picture is leaf, 0 to 255, from `inside` (0 to 1) at working size. Along the edge a
/// pixel is on the line between the colours of leaf and ground around it, in linear light, as light mixes.
pub fn fine_edge(
    picture: &WorkingPicture,
    inside: &[f32],
    width: usize,
    height: usize,
    rgba: &[u8],
) -> Vec<u8> {
    let plane = |value: &dyn Fn(usize) -> f32| {
        Plane { picture, values: (0..inside.len()).map(value).collect() }.around().values
    };
    // Clearly leaf, clearly ground: edges are of both.
    let sure = |i: usize, leaf: bool| {
        let part = if leaf { inside[i] } else { 1.0 - inside[i] };
        (part - 0.6).max(0.0)
    };
    let sums = |leaf: bool| -> Vec<[f32; 5]> {
        let square = |i: usize| picture.light[i].iter().map(|z| z * z).sum::<f32>();
        let sums: Vec<Vec<f32>> = (0..3)
            .map(|k| plane(&|i| sure(i, leaf) * picture.light[i][k]))
            .chain([plane(&|i| sure(i, leaf)), plane(&|i| sure(i, leaf) * square(i))])
            .collect();
        (0..inside.len()).map(|i| std::array::from_fn(|k| sums[k][i])).collect()
    };
    let (leaf, ground) = (sums(true), sums(false));
    let border = at_edge(picture, inside);
    let linear = Linear::new();
    let mut out = Vec::with_capacity(width * height);
    for y in 0..height {
        for x in 0..width {
            let places = Plane::places(picture, x, y);
            let value: f32 = places.iter().map(|&(i, part)| part * inside[i]).sum();
            if !(0.03..0.97).contains(&value) && !places.iter().any(|&(i, part)| part > 0.0 && border[i]) {
                out.push((255.0 * value.clamp(0.0, 1.0)).round() as u8);
                continue;
            }
            let read = |of: &[[f32; 5]]| -> Option<Seen> {
                let sum: [f32; 5] =
                    std::array::from_fn(|k| places.iter().map(|&(i, part)| part * of[i][k]).sum::<f32>());
                (sum[3] > 0.05).then(|| Seen::new(sum))
            };
            let i = 4 * (y * width + x);
            let fine = match (read(&leaf), read(&ground)) {
                (Some(leaf), Some(ground)) => mixed(linear.of(&rgba[i..i + 3]), &leaf, &ground, value),
                _ => value,
            };
            out.push((255.0 * fine.clamp(0.0, 1.0)).round() as u8);
        }
    }
    out
}

/// Which pixels at working size have leaf and ground within a pixel around them.
fn at_edge(picture: &WorkingPicture, inside: &[f32]) -> Vec<bool> {
    let (width, height) = (picture.width, picture.height);
    let leaf = |i: usize| inside[i] > 0.5;
    let both = |i: usize| {
        let (x, y) = (i % width, i / width);
        let mut around = (y.saturating_sub(1)..(y + 2).min(height))
            .flat_map(|y| (x.saturating_sub(1)..(x + 2).min(width)).map(move |x| y * width + x));
        around.any(|j| leaf(j) != leaf(i))
    };
    (0..inside.len()).map(both).collect()
}

/// What light comes from around a place.
struct Seen {
    mean: [f32; 3],
    /// The square of how far it is from the mean.
    spread: f32,
}

impl Seen {
    /// Of the sums of red, green, blue, weights and squares.
    fn new([r, g, b, all, square]: [f32; 5]) -> Self {
        let mean = [r / all, g / all, b / all];
        let spread = square / all - mean.iter().map(|z| z * z).sum::<f32>();
        Self { mean, spread: spread.max(0.0) }
    }
}

/// Which part of a colour is leaf; where leaf and ground are alike, or each is of many colours, it is what it was taken
/// for.
fn mixed(colour: [f32; 3], leaf: &Seen, ground: &Seen, otherwise: f32) -> f32 {
    let (mut along, mut long) = (0.0, 0.0);
    for ((here, leaf), ground) in colour.iter().zip(leaf.mean).zip(ground.mean) {
        let way = leaf - ground;
        along += (here - ground) * way;
        long += way * way;
    }
    let least = TELLING * TELLING + leaf.spread + ground.spread;
    ((along + least * otherwise) / (long + least)).clamp(0.0, 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn where_colours_are_many_the_cut_says_where_the_edge_is() {
        // Columns of light and dark to the right, whose mean is not far from the leaf.
        let light = |x: usize| if x < 50 { 0.5 } else { [0.1, 0.7][x % 2] };
        let encode = |z: f64| (255.0 * (1.055 * z.powf(1.0 / 2.4) - 0.055)).round() as u8;
        let rgba: Vec<u8> = (0..100 * 40).flat_map(|i| [encode(light(i % 100)); 4]).collect();
        let picture = WorkingPicture::new(100, 40, &rgba);
        let inside: Vec<f32> = (0..100 * 40).map(|i| if i % 100 < 50 { 0.9 } else { 0.1 }).collect();
        let fine = fine_edge(&picture, &inside, 100, 40, &rgba);
        assert!((0..100).all(|x| (fine[20 * 100 + x] > 127) == (x < 50)), "{:?}", &fine[2040..2060]);
    }

    #[test]
    fn half_covered_pixels_are_half() {
        // A straight edge at column 500.25 of a picture that is cut at a fifth of its size.
        let (width, height) = (1000, 900);
        let encode = |z: f64| (255.0 * (1.055 * z.powf(1.0 / 2.4) - 0.055)).round() as u8;
        let rgba: Vec<u8> = (0..width * height)
            .flat_map(|i| {
                let cover = (500.25 - (i % width) as f64).clamp(0.0, 1.0);
                [0.1 * cover + 0.6 * (1.0 - cover), 0.3 * cover + 0.5 * (1.0 - cover), 0.4]
                    .map(encode)
                    .into_iter()
                    .chain([255])
            })
            .collect();
        let picture = WorkingPicture::new(width, height, &rgba);
        assert!(picture.factor > 2);
        let inside: Vec<f32> = (0..picture.colours.len())
            .map(|i| if i % picture.width * picture.factor < 500 { 0.98 } else { 0.02 })
            .collect();
        let fine = fine_edge(&picture, &inside, width, height, &rgba);
        let row = &fine[450 * width..][..width];
        assert!(row[480] > 240 && row[499] > 240 && row[501] < 15 && row[520] < 15, "{:?}", &row[496..504]);
        assert!((f64::from(row[500]) / 255.0 - 0.25).abs() < 0.05, "{}", row[500]);
    }
}
