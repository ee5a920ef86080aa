//! All objects of a moment, as pictures need them.

use std::ops::Range;
use std::sync::{Arc, OnceLock};

use frond_core::{Affine3, Bounds3, Colouring, Ifs3};
use glam::DVec3;

use super::points::Cloud;
use super::shape::Shape;
use super::traversal::Subject;
use super::{Bent, Camera, Lighting, Traversal, depths};
use crate::picture::colour::Colours;

/// Systems with their colours, in units that single precision can hold.
#[derive(Clone, Debug)]
pub struct Objects {
    systems: Vec<Ifs3>,
    bends: Vec<Option<Bent>>,
    bounds: Vec<Bounds3>,
    /// What traversals need of them, made for the first one.
    carved: OnceLock<Vec<Carved>>,
    tints: Vec<Option<[f32; 3]>>,
    heights: [f64; 2],
    centre: DVec3,
    radius: f64,
    unit: f64,
}

/// A shape, and where it lies when it is bent as it is.
#[derive(Clone, Debug)]
struct Carved {
    shape: Arc<Shape>,
    bounds: Bounds3,
}

/// Scenes of sizes between these are drawn as they are.
const PLAIN_SIZES: Range<f64> = 1e-6..1e6;

impl Objects {
    /// Of systems, each with a colour for all of it where it has one, and bent where it is.
    #[must_use]
    pub fn new(systems: Vec<Ifs3>, tints: Vec<Option<[f32; 3]>>, bends: Vec<Option<Bent>>) -> Self {
        let (mut systems, mut bends) = (systems, bends);
        bends.resize(systems.len(), None);
        let bounded = |systems: &[Ifs3], bends: &[Option<Bent>]| -> Vec<Bounds3> {
            let of = |(ifs, bent): (&Ifs3, &Option<Bent>)| {
                bent.as_ref().map_or_else(|| Bounds3::coarse(ifs), Bent::bounds)
            };
            systems.iter().zip(bends).map(of).collect()
        };
        let mut bounds = bounded(&systems, &bends);
        let size = bounds.iter().map(|b| b.min.abs().max(b.max.abs()).max_element()).fold(0.0, f64::max);
        let mut unit = 1.0;
        if size > 0.0 && size.is_finite() && !PLAIN_SIZES.contains(&size) {
            // A power of two, so that no number loses a digit.
            let two = size.log2().round().exp2();
            let by = Affine3::scaling(DVec3::splat(1.0 / two));
            if let Ok(smaller) = systems.iter().map(|ifs| ifs.conjugate(by)).collect::<Result<Vec<_>, _>>() {
                bends = bends.iter().map(|bent| bent.as_ref().map(|bent| bent.moved(by))).collect();
                bounds = bounded(&smaller, &bends);
                (systems, unit) = (smaller, two);
            }
        }
        let least = bounds.iter().map(|b| b.min).reduce(DVec3::min).unwrap_or(DVec3::ZERO);
        let largest = bounds.iter().map(|b| b.max).reduce(DVec3::max).unwrap_or(DVec3::ZERO);
        let (centre, radius) = match &bounds[..] {
            [only] => (only.centre, only.radius),
            _ => {
                let centre = 0.5 * (least + largest);
                let reach = |b: &Bounds3| (b.centre - centre).length() + b.radius;
                (centre, bounds.iter().map(reach).fold(0.0, f64::max))
            }
        };
        let heights = [least.z, largest.z];
        Self { systems, bends, bounds, carved: OnceLock::new(), tints, heights, centre, radius, unit }
    }

    /// What each of them lies in, in their units.
    pub(super) fn bounds(&self) -> &[Bounds3] {
        &self.bounds
    }

    /// The bends, one an object.
    #[must_use]
    pub fn bends(&self) -> &[Option<Bent>] {
        &self.bends
    }

    /// What lengths are divided by: a graphics card has single precision.
    #[must_use]
    pub fn unit(&self) -> f64 {
        self.unit
    }

    /// The middle of a ball around everything.
    #[must_use]
    pub fn centre(&self) -> DVec3 {
        self.centre * self.unit
    }

    /// Its radius.
    #[must_use]
    pub fn radius(&self) -> f64 {
        self.radius * self.unit
    }

    /// The same lighting with the heights and the colours of these objects.
    #[must_use]
    pub fn lit(&self, mut lighting: Lighting) -> Lighting {
        lighting.heights = self.heights;
        lighting.tints.clone_from(&self.tints);
        lighting
    }

    /// The colours of their maps.
    #[must_use]
    pub fn colours(&self, palette: &[[u8; 3]]) -> Colours {
        let maps = self.systems.iter().map(Ifs3::len).max().unwrap_or(1);
        Colours::new(Colouring::Map, palette, maps)
    }

    /// The nearest and the farthest depth before a camera.
    #[must_use]
    pub fn depths(&self, camera: &Camera) -> [f32; 2] {
        depths(&self.bounds, camera)
    }

    /// The complete picture before a camera, not yet begun.
    #[must_use]
    pub fn traversal(&self, camera: &Camera, width: u32, height: u32) -> Traversal {
        self.band(camera, [width, height], 0..height)
    }

    /// Some rows of it: a picture may be made band by band, side by side.
    #[must_use]
    pub fn band(&self, camera: &Camera, size: [u32; 2], rows: Range<u32>) -> Traversal {
        let carved = self.carved.get_or_init(|| self.carved());
        let subjects = carved.iter().zip(&self.bends);
        let subjects =
            subjects.map(|(Carved { shape, bounds }, bent)| Subject { shape, bent: bent.as_ref(), bounds });
        Traversal::of(subjects, camera, size, [rows.start, rows.end])
    }

    fn carved(&self) -> Vec<Carved> {
        let of = |((ifs, bent), bounds): ((&Ifs3, &Option<Bent>), &Bounds3)| match bent {
            Some(bent) => {
                let shape = Shape::new(bent.ifs(), &Bounds3::of(bent.ifs()));
                Carved { shape: Arc::new(shape), bounds: *bounds }
            }
            None => {
                let bounds = Bounds3::of(ifs);
                Carved { shape: Arc::new(Shape::new(ifs, &bounds)), bounds }
            }
        };
        self.systems.iter().zip(&self.bends).zip(&self.bounds).map(of).collect()
    }

    /// About so many points in all, shared by the objects.
    #[must_use]
    pub fn clouds(&self, points: f64) -> Vec<Cloud> {
        // Large objects take up more of the picture, and small ones want to be seen as well.
        let whole: f64 = self.bounds.iter().map(|bounds| bounds.radius).sum();
        let points = points.clamp(0.0, 1e8);
        let share = |radius: f64| {
            let part = if whole > 0.0 { radius / whole } else { 1.0 };
            ((points * part) as usize).max(1)
        };
        let cloud = |(number, (ifs, bounds)): (usize, (&Ifs3, &Bounds3))| {
            let (count, seed) = (share(bounds.radius), 1 + number as u32);
            match &self.bends[number] {
                Some(bent) => bent.cloud(number as u32, count, seed),
                None => Cloud::new(ifs, number as u32, count, seed),
            }
        };
        self.systems.iter().zip(&self.bounds).enumerate().map(cloud).collect()
    }
}
