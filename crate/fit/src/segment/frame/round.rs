//! A disc, perhaps cut by the border of the picture, or an upright ellipse.

use frond_core::shared::sort_indices;

use crate::segment::binary_image::Bits;

/// The rim is a circle to this part of its radius, at so many places at least: there may be a leaf that touches it.
const STRAY: f64 = 0.012;
const ROUND: f64 = 0.75;
/// At so many at most the field reaches beyond it.
const BEYOND: f64 = 0.03;
/// Its shorter diameter is at least this part of the shorter side of the picture.
const LEAST_DIAMETER: f64 = 0.7;
/// Where light fades towards the rim, the disc ends where so much of the difference to the frame is reached, but no
/// nearer to its centre than this.
const LIT: f64 = 0.88;
const INNERMOST: f64 = 0.65;
/// Of twelve parts of its rim so many are seen at least.
const LEAST_SEEN: usize = 5;

/// An upright ellipse.
#[derive(Clone, Copy, Debug)]
pub struct Disc {
    centre: [f64; 2],
    radii: [f64; 2],
}

impl Disc {
    /// The disc that a field is, if it is one.
    pub fn around(field: &Bits) -> Option<Self> {
        let rim = rim(field);
        if rim.len() < 24 {
            return None;
        }
        let ellipses = upright(&rim).into_iter().chain([central(&rim, field.width, field.height)]);
        let fits = |disc: &Self| disc.near(&rim);
        let disc = ellipses.chain(circles(&rim)).max_by_key(fits)?;
        let stray = disc.stray();
        let beyond = rim.iter().filter(|&&p| disc.of(p) > 1.0 + stray).count() as f64;
        let [a, b] = disc.radii;
        let short = field.width.min(field.height) as f64;
        let mut seen = [false; 12];
        for &p in rim.iter().filter(|&&p| (disc.of(p) - 1.0).abs() <= stray) {
            let angle = (p[1] - disc.centre[1]).atan2(p[0] - disc.centre[0]) / std::f64::consts::TAU;
            seen[((12.0 * (angle + 0.5)) as usize).min(11)] = true;
        }
        let is_round = fits(&disc) as f64 >= ROUND * rim.len() as f64
            && beyond <= BEYOND * rim.len() as f64
            && 2.0 * a.min(b) >= LEAST_DIAMETER * short
            && seen.iter().filter(|&&seen| seen).count() >= LEAST_SEEN;
        is_round.then_some(disc)
    }

    /// Whether a pixel lies beyond its rim.
    pub fn is_outside(&self, x: usize, y: usize) -> bool {
        self.of([x as f64, y as f64]) > 1.0
    }

    /// The part of it that is lit: at an edge that is not sharp, and in a vignette, light fades. `light` is that of
    /// each pixel of a picture so many pixels across.
    pub fn lit(&self, light: &[u8], width: usize) -> Self {
        const RINGS: usize = 40;
        let step = (1.0 - INNERMOST) / RINGS as f64;
        let mut rings = vec![Vec::new(); RINGS];
        let mut outside = Vec::new();
        for (i, &light) in light.iter().enumerate() {
            let far = self.of([(i % width) as f64, (i / width) as f64]);
            if far > 1.0 {
                outside.push(light);
            } else if far > INNERMOST {
                rings[(((1.0 - far) / step) as usize).min(RINGS - 1)].push(light);
            }
        }
        let frame = f64::from(middle(outside).unwrap_or(0));
        let apart = |ring: Vec<u8>| middle(ring).map_or(0.0, |light| (f64::from(light) - frame).abs());
        let apart: Vec<f64> = rings.into_iter().map(apart).collect();
        let most = apart.iter().copied().fold(0.0, f64::max);
        let first = apart.iter().position(|&apart| apart >= LIT * most).unwrap_or(0);
        let part = 1.0 - first as f64 * step;
        Self { centre: self.centre, radii: self.radii.map(|radius| part * radius) }
    }

    /// Less than 1 inside, more outside.
    fn of(&self, p: [f64; 2]) -> f64 {
        let part = |k: usize| (p[k] - self.centre[k]) / self.radii[k];
        part(0).hypot(part(1))
    }

    fn stray(&self) -> f64 {
        STRAY.max(1.5 / self.radii[0].min(self.radii[1]))
    }

    fn near(&self, rim: &[[f64; 2]]) -> usize {
        let stray = self.stray();
        rim.iter().filter(|&&p| (self.of(p) - 1.0).abs() <= stray).count()
    }
}

fn middle(mut values: Vec<u8>) -> Option<u8> {
    let at = values.len() / 2;
    (!values.is_empty()).then(|| *values.select_nth_unstable(at).1)
}

/// The ends of rows and columns of a field that are not at the border of the picture.
fn rim(field: &Bits) -> Vec<[f64; 2]> {
    let (width, height) = (field.width, field.height);
    let mut rim = Vec::new();
    for y in 0..height {
        let row = &field.on[y * width..(y + 1) * width];
        let ends = [row.iter().position(|&on| on), row.iter().rposition(|&on| on)];
        rim.extend(ends.iter().flatten().filter(|&&x| x > 0 && x + 1 < width).map(|&x| [x as f64, y as f64]));
    }
    for x in 0..width {
        let on = |y: &usize| field.on[y * width + x];
        let ends = [(0..height).find(on), (0..height).rfind(on)];
        rim.extend(
            ends.iter().flatten().filter(|&&y| y > 0 && y + 1 < height).map(|&y| [x as f64, y as f64]),
        );
    }
    rim
}

/// The ellipse in the box around the rim.
fn upright(rim: &[[f64; 2]]) -> Option<Disc> {
    let range = |k: usize| {
        let each = || rim.iter().map(|p| p[k]);
        (each().fold(f64::INFINITY, f64::min), each().fold(f64::NEG_INFINITY, f64::max))
    };
    let ((left, right), (top, bottom)) = (range(0), range(1));
    let radii = [0.5 * (right - left) + 0.5, 0.5 * (bottom - top) + 0.5];
    (radii[0] > 4.0 && radii[1] > 4.0)
        .then_some(Disc { centre: [0.5 * (left + right), 0.5 * (top + bottom)], radii })
}

/// The ellipse around the middle of the picture that is as wide and high as this in proportion: of a vignette, which
/// the border may cut.
fn central(rim: &[[f64; 2]], width: usize, height: usize) -> Disc {
    let whole = Disc {
        centre: [width, height].map(|side| 0.5 * (side as f64 - 1.0)),
        radii: [width, height].map(|side| 0.5 * side as f64),
    };
    let far: Vec<f64> = rim.iter().map(|&p| whole.of(p)).collect();
    let mut order: Vec<usize> = (0..far.len()).collect();
    sort_indices(&mut order, &|i, j| far[i].total_cmp(&far[j]));
    let part = far[order[far.len() / 2]];
    Disc { radii: whole.radii.map(|radius| part * radius), ..whole }
}

/// Circles through three places of the rim each.
fn circles(rim: &[[f64; 2]]) -> impl Iterator<Item = Disc> {
    const PLACES: usize = 14;
    let place = move |k: usize| rim[k * (rim.len() - 1) / (PLACES - 1)];
    let threes =
        (0..PLACES).flat_map(|i| (i + 1..PLACES).flat_map(move |j| (j + 1..PLACES).map(move |k| [i, j, k])));
    threes.filter_map(move |three| circle(three.map(place)))
}

fn circle([p, q, r]: [[f64; 2]; 3]) -> Option<Disc> {
    let (u, v) = ([q[0] - p[0], q[1] - p[1]], [r[0] - p[0], r[1] - p[1]]);
    let cross = 2.0 * (u[0] * v[1] - u[1] * v[0]);
    let square = |w: [f64; 2]| w[0] * w[0] + w[1] * w[1];
    if cross.abs() < 1e-3 * (square(u) + square(v)) {
        return None;
    }
    let off = [(v[1] * square(u) - u[1] * square(v)) / cross, (u[0] * square(v) - v[0] * square(u)) / cross];
    let radius = off[0].hypot(off[1]);
    (4.0..1e5)
        .contains(&radius)
        .then_some(Disc { centre: [p[0] + off[0], p[1] + off[1]], radii: [radius; 2] })
}
