//! What there is in space.

use frond_core::{Affine3, Course, Ease, Ifs3, IfsError, MAX_MAPS, Mode, MorphOptions};
use serde::{Deserialize, Deserializer, Serialize};

use crate::scene::Path;
use crate::space::bend::SpaceBend;
use crate::space::evening::{SKY, evening_scene};
use crate::space::natural::natural_scene;
use crate::space::part::{Held, SpaceView};
use crate::space::preset::{Row3, preset3};

/// The most objects.
pub const MAX_OBJECTS3: usize = 60;
/// The most key frames.
pub const MAX_KEYS3: usize = 100;
/// Names of the objects of the natural scene begin so, and end with their numbers from 0.
const EVENING_PREFIX: &str = "evening-";
/// The same of the scene of older links.
const NATURAL_PREFIX: &str = "natural-";

/// The number that stands after the first part of an id.
fn numbered(id: &str, prefix: &str) -> Option<usize> {
    id.strip_prefix(prefix)?.parse().ok()
}

/// A shape of space.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct Shape3 {
    /// Its id in the gallery, or in the natural scene, while its maps are those.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub preset: Option<String>,
    /// Its name.
    pub name: String,
    /// Its maps.
    pub maps: Vec<Row3>,
}

impl Shape3 {
    /// The shape of the gallery, or of the natural scene, with this id.
    #[must_use]
    pub fn of_preset(id: &str) -> Option<Self> {
        let (name, maps) = if let Some(number) = numbered(id, NATURAL_PREFIX) {
            natural_scene().get(number).map(|thing| (thing.name, thing.maps.clone()))?
        } else if let Some(number) = numbered(id, EVENING_PREFIX) {
            evening_scene().get(number).map(|thing| (thing.name, thing.maps.clone()))?
        } else {
            preset3(id).map(|preset| (preset.name, preset.maps))?
        };
        Some(Self { preset: Some(id.to_owned()), name: name.to_owned(), maps })
    }

    /// Its system.
    ///
    /// # Errors
    /// [`IfsError`] if the maps have no attractor.
    pub fn ifs(&self) -> Result<Ifs3, IfsError> {
        system(&self.maps)
    }
}

/// The system of these maps, whatever their number.
pub(super) fn system(maps: &[Row3]) -> Result<Ifs3, IfsError> {
    if maps.len() > MAX_MAPS {
        return Err(IfsError::TooManyMaps { count: maps.len() });
    }
    Ifs3::new(affine(maps))
}

pub(super) fn affine(maps: &[Row3]) -> Vec<Affine3> {
    maps.iter().copied().map(Affine3::from_row).collect()
}

/// A shape in its place: its parameters are its maps, conjugated by `moved` (Darwish & Abd-El-Wahab, eq 1).
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct SpaceObject {
    /// The shape as it was made.
    #[serde(flatten)]
    pub shape: Shape3,
    /// All that was done to it; nothing where absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub moved: Option<Row3>,
    /// `#rrggbb`: one colour for all of it; its maps have theirs where absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tint: Option<String>,
    /// How it is bent before that; not at all where absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub bend: Option<SpaceBend>,
}

impl SpaceObject {
    /// The object of the gallery, or of the natural scene, with this id.
    #[must_use]
    pub fn of_preset(id: &str) -> Option<Self> {
        let shape = Shape3::of_preset(id)?;
        let older = numbered(id, NATURAL_PREFIX).and_then(|number| natural_scene().get(number));
        let tint = older.map(|thing| match thing.tint {
            "ground" => "#8a7a52",
            "cloud" => "#d5dde6",
            _ => "#3f8f4f",
        });
        let tint = tint.or_else(|| Some(evening_scene().get(numbered(id, EVENING_PREFIX)?)?.tint));
        let tint = tint.map(str::to_owned);
        Some(Self { shape, moved: None, tint, bend: None })
    }
}

/// The objects of the natural scene.
#[must_use]
pub fn natural_objects() -> Vec<SpaceObject> {
    (0..evening_scene().len())
        .filter_map(|k| SpaceObject::of_preset(&format!("{EVENING_PREFIX}{k}")))
        .collect()
}

/// The natural scene in evening light, before a sky of its own: it looks the same on every page.
#[must_use]
pub fn natural_space() -> Space {
    let light =
        SpaceLight { side: -1.05, front: 0.3, ambient: 0.3, fog: 0.5, sky: 0.8, ..SpaceLight::fresh() };
    let background = Some(SKY.to_owned());
    Space { objects: natural_objects(), light, background, morph: None, timeline: None }
}

/// A background that is that of the page.
pub const PAGE_BACKGROUND: &str = "page";

/// What colours a pixel.
#[derive(Clone, Copy, Debug, Default, Deserialize, Eq, PartialEq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum PaintName {
    /// Its map.
    #[default]
    Map,
    /// How high it lies.
    Height,
}

/// How a scene is lit. All but `paint` and `side` are 0 to 1.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct SpaceLight {
    /// What colours a pixel.
    pub paint: PaintName,
    /// Where the light comes from, as the eye has it: radians from straight above, positive to the right.
    pub side: f64,
    /// How far the light stands on the eye's side: 0 grazes, 1 is from the eye.
    pub front: f64,
    /// How much of the light comes from everywhere.
    pub ambient: f64,
    /// How dark hollows are.
    pub hollows: f64,
    /// How much fades into the ground colour at the farthest depth.
    pub fog: f64,
    /// How dark cast shadows are. This and what follows is 0 in what was made before there was a choice.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub shadows: f64,
    /// How soft their edges are.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub softness: f64,
    /// How much of the light from everywhere what is around keeps off.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub occlusion: f64,
    /// How far the light from everywhere is that of a blue sky, and the other warm.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub sky: f64,
    /// From rough to glossy.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub gloss: f64,
    /// Whether bright tones are compressed, as on film, and not cut off.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub filmic: bool,
}

/// As serde asks.
fn is_zero(share: &f64) -> bool {
    *share == 0.0
}

impl Default for SpaceLight {
    /// That of documents that say nothing of it.
    fn default() -> Self {
        Self {
            paint: PaintName::Map,
            side: -0.56,
            front: 0.55,
            ambient: 0.35,
            hollows: 0.75,
            fog: 0.25,
            shadows: 0.0,
            softness: 0.0,
            occlusion: 0.0,
            sky: 0.0,
            gloss: 0.0,
            filmic: false,
        }
    }
}

impl SpaceLight {
    /// That of what is made now.
    #[must_use]
    pub fn fresh() -> Self {
        Self {
            ambient: 0.25,
            hollows: 0.35,
            shadows: 0.85,
            softness: 0.35,
            occlusion: 0.8,
            sky: 0.5,
            filmic: true,
            ..Self::default()
        }
    }

    /// The numbers of its finish, in the order of a link: those that older documents lack.
    #[must_use]
    pub fn finish(&self) -> [f64; 6] {
        let Self { shadows, softness, occlusion, sky, gloss, filmic, .. } = *self;
        [shadows, softness, occlusion, sky, gloss, f64::from(u8::from(filmic))]
    }

    /// The same with these; `None` where one cannot be.
    #[must_use]
    pub fn with_finish(self, [shadows, softness, occlusion, sky, gloss, filmic]: [f64; 6]) -> Option<Self> {
        let filmic = if filmic == 1.0 {
            true
        } else if filmic == 0.0 {
            false
        } else {
            return None;
        };
        Some(Self { shadows, softness, occlusion, sky, gloss, filmic, ..self })
    }

    /// Its numbers, in the order of a link.
    #[must_use]
    pub fn numbers(&self) -> [f64; 5] {
        [self.side, self.front, self.ambient, self.hollows, self.fog]
    }
}

/// The first object on its way to another shape.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct SpaceMorph {
    /// The other shape.
    pub to: Shape3,
    /// How the linear parts are interpolated.
    #[serde(default)]
    pub mode: Mode,
    /// The way there.
    #[serde(default)]
    pub path: Path,
    /// Where along the way, 0 to 1.
    #[serde(default)]
    pub t: f64,
    /// Which map becomes which; empty for the order they are in.
    #[serde(default)]
    pub correspondence: Vec<usize>,
    /// Whole extra turns; empty for none.
    #[serde(default)]
    pub turns: Vec<i32>,
}

impl SpaceMorph {
    /// The choices of the morph.
    #[must_use]
    pub fn options(&self) -> MorphOptions {
        MorphOptions {
            mode: self.mode,
            correspondence: self.correspondence.clone(),
            turns: self.turns.clone(),
        }
    }
}

/// What comes after the end of a time line.
#[derive(Clone, Copy, Debug, Default, Deserialize, Eq, PartialEq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Repeat {
    /// Nothing.
    #[default]
    Once,
    /// Its beginning: the last key goes on to the first, or jumps there from the end.
    Round,
    /// The way back to its beginning, and so on.
    PingPong,
}

/// Older documents say whether it goes round.
pub(super) fn read_repeat<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Repeat, D::Error> {
    #[derive(Deserialize)]
    #[serde(untagged, expecting = "`loop` is \"once\", \"round\" or \"pingpong\"")]
    enum Written {
        Older(bool),
        Name(Repeat),
    }
    Written::deserialize(deserializer).map(|written| match written {
        Written::Older(false) => Repeat::Once,
        Written::Older(true) => Repeat::Round,
        Written::Name(repeat) => repeat,
    })
}

/// All that is, at one moment; what is absent goes on as if there were no key here.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Serialize)]
pub struct SpaceKey {
    /// Seconds.
    pub at: f64,
    /// How it goes on to the next key.
    #[serde(default)]
    pub ease: Ease,
    /// Where it is seen from.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub view: Option<SpaceView>,
    /// For each object what was done to it.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub moved: Vec<Option<Row3>>,
    /// For each object its maps.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub maps: Vec<Option<Vec<Row3>>>,
    /// For each object that is bent how far the control points of its lattice are moved, as in [`SpaceBend::moves`].
    /// What is of another number of control points is passed over.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub bends: Vec<Option<Vec<[f64; 3]>>>,
    /// Where along the path of the morph.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub t: Option<f64>,
}

/// A time line.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct Timeline {
    /// How long it is, in seconds.
    pub seconds: f64,
    /// What comes after its end.
    #[serde(rename = "loop", deserialize_with = "read_repeat")]
    pub repeat: Repeat,
    /// The way from key to key.
    pub course: Course,
    /// In the order of their times.
    pub keys: Vec<SpaceKey>,
}

/// What there is in space, and how it moves.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct Space {
    /// 1 to 60.
    pub objects: Vec<SpaceObject>,
    /// How it is lit.
    #[serde(default)]
    pub light: SpaceLight,
    /// What it is seen before: `#rrggbb`, or `page` for the colour under the pictures of whatever page shows it. Absent
    /// in what was made before there was a choice.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub background: Option<String>,
    /// What the first object becomes.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub morph: Option<SpaceMorph>,
    /// How all moves.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub timeline: Option<Timeline>,
}

impl Default for Space {
    /// What a visitor sees first.
    fn default() -> Self {
        let object = SpaceObject::of_preset("sponge").unwrap_or_else(|| unreachable!("it is in the gallery"));
        let light = SpaceLight::fresh();
        Self { objects: vec![object], light, background: None, morph: None, timeline: None }
    }
}

/// How high a picture is, in radians, unless somebody chose.
const USUAL_ANGLE: f64 = 0.7;

impl Space {
    /// The view that shows all of it, from a little above; that of the eye at the origin for the natural scene.
    #[must_use]
    pub fn whole_view(&self) -> SpaceView {
        let natural = |object: &SpaceObject| {
            let id = object.shape.preset.as_deref();
            id.is_some_and(|id| [NATURAL_PREFIX, EVENING_PREFIX].iter().any(|prefix| id.starts_with(prefix)))
        };
        if self.objects.len() > 1 && self.objects.iter().all(natural) {
            // Along x, as the paper has it.
            let (target, distance) = ([12.0, 0.0, 0.0], 12.0);
            let turn = -std::f64::consts::FRAC_PI_2;
            return SpaceView { target, distance, turn, tilt: 0.0, angle: 0.46, holds: Some(Held::Eye) };
        }
        let (centre, radius) = self.ball();
        // A point alone is seen from near by.
        let radius = if radius > 0.0 { radius } else { 1.0 };
        let distance = 1.08 * radius / (0.5 * USUAL_ANGLE).sin();
        SpaceView { target: centre, distance, turn: 0.5, tilt: 0.42, angle: USUAL_ANGLE, holds: None }
    }

    /// A ball around all objects, where they are when nothing moves.
    fn ball(&self) -> ([f64; 3], f64) {
        use frond_core::Bounds3;
        let shapes = self.objects.iter().map(|object| (&object.shape, object.moved));
        let goal = self.morph.as_ref().map(|morph| (&morph.to, self.objects.first().and_then(|o| o.moved)));
        let balls: Vec<_> = shapes
            .chain(goal)
            .filter_map(|(shape, moved)| {
                let ifs = shape.ifs().ok()?;
                let by = moved.map_or(Affine3::IDENTITY, Affine3::from_row);
                Some(Bounds3::of(&ifs.conjugate(by).ok()?))
            })
            .collect();
        let Some(first) = balls.first() else { return ([0.0; 3], 1.0) };
        let (mut centre, mut radius) = (first.centre, first.radius);
        for ball in &balls[1..] {
            let apart = (ball.centre - centre).length();
            if apart + ball.radius <= radius {
                continue;
            }
            if apart + radius <= ball.radius {
                (centre, radius) = (ball.centre, ball.radius);
                continue;
            }
            let whole = 0.5 * (apart + radius + ball.radius);
            centre += (ball.centre - centre) * ((whole - radius) / apart);
            radius = whole;
        }
        (centre.to_array(), radius)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_the_gallery_has_can_be_shown() {
        let ids: Vec<String> = crate::presets3().iter().map(|preset| preset.id.to_owned()).collect();
        for id in &ids {
            let object = SpaceObject::of_preset(id).unwrap();
            let space = Space { objects: vec![object], ..Space::default() };
            assert!(space.whole_view().is_one(), "{id}");
        }
        let objects = natural_objects();
        assert_eq!(objects.len(), evening_scene().len());
        let view = Space { objects, ..Space::default() }.whole_view();
        assert!(view.is_one() && view.eye().iter().all(|x| x.abs() < 1e-9), "the eye is at the origin");
        assert_eq!(Shape3::of_preset("natural-99"), None);
        assert_eq!(Shape3::of_preset("nothing"), None);
    }

    #[test]
    fn a_view_of_two_holds_both() {
        let near = SpaceObject::of_preset("sponge").unwrap();
        let mut far = near.clone();
        far.moved = Some([1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 8.0, 0.0, 0.0]);
        let one = Space { objects: vec![near.clone()], ..Space::default() }.whole_view();
        let two = Space { objects: vec![near, far], ..Space::default() }.whole_view();
        assert!((two.target[0] - one.target[0] - 4.0).abs() < 1e-9 && two.distance > one.distance * 1.5);
    }
}
