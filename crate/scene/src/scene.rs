//! The document.

use frond_core::{Affine2, Colouring, Ifs, IfsError, Mode};
use serde::{Deserialize, Serialize};

use crate::curve::Curves;
use crate::deformation::Deformation;
use crate::directed::Directed;
use crate::fit::Fit;
use crate::preset::{Row, preset};
use crate::space::SpacePart;

/// The most waypoints a path may have between its ends.
pub const MAX_WAY_POINTS: usize = 64;

/// One end of a morph.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct Shape {
    /// Its id in the gallery, while its maps are those of the gallery.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub preset: Option<String>,
    /// Its name.
    pub name: String,
    /// Its maps.
    pub maps: Vec<Row>,
    /// How often the chaos game takes each map, none below 0: shares, whatever their sum. Where there are none, each
    /// in proportion to its area.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub weights: Vec<f64>,
    /// Formulas of numbers, such as "1/3": where an entry of a map is the double nearest to one of them or to its
    /// negative, that number is meant, and not the double.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub exact: Vec<String>,
}

impl Shape {
    /// The shape of the gallery with this id.
    #[must_use]
    pub fn of_preset(id: &str) -> Option<Self> {
        let found = preset(id)?;
        Some(Self {
            preset: Some(found.id.to_owned()),
            name: found.name.to_owned(),
            maps: found.maps,
            weights: Vec::new(),
            exact: Vec::new(),
        })
    }

    /// Its system.
    ///
    /// # Errors
    /// [`IfsError`] if the maps have no attractor, or the weights are not one for each of them.
    pub fn ifs(&self) -> Result<Ifs, IfsError> {
        // Before any memory is asked for: the list may be of any length.
        if self.maps.len() > frond_core::MAX_MAPS {
            return Err(IfsError::TooManyMaps { count: self.maps.len() });
        }
        let ifs = Ifs::new(self.maps.iter().map(|&row| Affine2::from_row(row)).collect())?;
        if self.weights.is_empty() { Ok(ifs) } else { ifs.with_probabilities(&self.weights) }
    }
}

/// Who drew the path.
#[derive(Clone, Copy, Debug, Default, Deserialize, Eq, PartialEq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum PathKind {
    /// Frond, so that the shape stays in one piece.
    #[default]
    Auto,
    /// Nobody: the straight line.
    Straight,
    /// The user.
    Drawn,
}

/// A parameter of a morph: `[u, v]`, or `[u, v, w]` where the stretch is ahead of the turn by w.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Serialize)]
#[serde(try_from = "Vec<f64>", into = "Vec<f64>")]
pub struct WayPoint {
    /// How far it has turned and stretched.
    pub u: f64,
    /// How far it has moved.
    pub v: f64,
    /// How far the stretch is ahead of the turn.
    pub w: f64,
}

impl WayPoint {
    /// Its numbers; a third only where it is not 0.
    #[must_use]
    pub fn numbers(&self) -> Vec<f64> {
        let Self { u, v, w } = *self;
        if w == 0.0 { vec![u, v] } else { vec![u, v, w] }
    }

    /// From two or three numbers.
    #[must_use]
    pub fn from_numbers(numbers: &[f64]) -> Option<Self> {
        match *numbers {
            [u, v] => Some(Self { u, v, w: 0.0 }),
            [u, v, w] => Some(Self { u, v, w }),
            _ => None,
        }
    }
}

impl From<WayPoint> for Vec<f64> {
    fn from(point: WayPoint) -> Self {
        point.numbers()
    }
}

impl TryFrom<Vec<f64>> for WayPoint {
    type Error = &'static str;

    fn try_from(numbers: Vec<f64>) -> Result<Self, Self::Error> {
        Self::from_numbers(&numbers).ok_or("a waypoint has two or three numbers")
    }
}

/// A way through the parameters from (0, 0) to (1, 1), which are not listed.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Serialize)]
pub struct Path {
    /// Who drew it.
    pub kind: PathKind,
    /// The waypoints in between.
    pub points: Vec<WayPoint>,
}

/// What a locus is the locus of.
#[derive(Clone, Copy, Debug, Default, Deserialize, Eq, PartialEq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum FamilyName {
    /// The morph, over (u, v).
    #[default]
    Morph,
    /// The systems s z + exp(2 pi i k / sides), over the complex s.
    Polygon,
}

/// How the locus is looked at.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
pub struct LocusView {
    /// What it is the locus of.
    pub family: FamilyName,
    /// Of the polygon family, 2 to 64; two sides are the set M.
    pub sides: u32,
    /// The parameter in the middle, across.
    pub x: f64,
    /// The parameter in the middle, up.
    pub y: f64,
    /// Magnification over the view of all.
    pub zoom: f64,
    /// The slice of the morph.
    pub w: f64,
    /// A parameter off the path that the picture shows instead; of a polygon family, s.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub at: Option<WayPoint>,
}

impl LocusView {
    /// All of the locus of this family.
    #[must_use]
    pub const fn whole(family: FamilyName) -> Self {
        let middle = match family {
            FamilyName::Morph => 0.5,
            FamilyName::Polygon => 0.0,
        };
        Self { family, sides: 2, x: middle, y: middle, zoom: 1.0, w: 0.0, at: None }
    }
}

/// The part of the plane that is looked at.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
pub struct Window {
    /// World x of the middle.
    pub x: f64,
    /// World y of the middle.
    pub y: f64,
    /// Magnification over the view that fits the whole shape.
    pub zoom: f64,
}

/// Everything that a link holds.
///
/// ```
/// use frond_core::Colouring;
/// use frond_scene::{Scene, decode, encode};
///
/// let scene = Scene { colouring: Colouring::Density, ..Scene::default() };
/// let link = encode(&scene)?;
/// assert_eq!(decode(&link), (scene, None));
/// // What is damaged opens as the default, with a reason.
/// let (opened, reason) = decode("v=1&colour=loud");
/// assert_eq!(opened, Scene::default());
/// assert!(reason.is_some());
/// # Ok::<(), frond_scene::LinkError>(())
/// ```
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct Scene {
    /// The first shape.
    pub a: Shape,
    /// The last shape.
    pub b: Shape,
    /// How the linear parts are interpolated.
    #[serde(default)]
    pub mode: Mode,
    /// The way from the first to the last.
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
    /// What colours mean.
    #[serde(default)]
    pub colouring: Colouring,
    /// The colours of its maps, "#rrggbb", repeated where there are more maps; the page's own where there are none.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub palette: Vec<String>,
    /// Whether the elementwise morph is shown beside the polar one.
    #[serde(default)]
    pub compare: bool,
    /// The part of the plane that is looked at; the whole shape where absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub view: Option<Window>,
    /// How the locus is looked at; all of the morph's where absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub locus: Option<LocusView>,
    /// The tool that is open.
    #[serde(default, skip_serializing_if = "is_morph")]
    pub tool: Tool,
    /// What bends the shape; nothing where absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub deform: Option<Deformation>,
    /// The closed curves that are worked on in place of the shapes.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub curves: Option<Curves>,
    /// The graph-directed shapes that are worked on in place of the shapes.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub directed: Option<Directed>,
    /// How an outline or a graph was fitted last.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub fit: Option<Fit>,
    /// What there is in space; what the tool begins with where absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub space: Option<SpacePart>,
}

/// The tool that is open. Its name goes into links and is never changed afterwards.
#[derive(Clone, Copy, Debug, Default, Deserialize, Eq, PartialEq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Tool {
    /// The morph.
    #[default]
    Morph,
    /// The deformation grid.
    Deform,
    /// From an outline to its formula.
    Fit,
    /// Space.
    Space,
}

impl Tool {
    /// What they are called in links; the first is open where a link says nothing.
    pub(crate) const NAMES: [(&str, Self); 4] =
        [("morph", Self::Morph), ("deform", Self::Deform), ("fit", Self::Fit), ("space", Self::Space)];
}

fn is_morph(tool: &Tool) -> bool {
    *tool == Tool::Morph
}

impl Default for Scene {
    /// What a visitor sees first: the dragon of three maps, on its way to the gasket.
    fn default() -> Self {
        let shape = |id| Shape::of_preset(id).unwrap_or_else(|| unreachable!("{id} is in the gallery"));
        Self {
            a: shape("dragon-3"),
            b: shape("gasket"),
            mode: Mode::Polar,
            path: Path::default(),
            t: 0.0,
            correspondence: Vec::new(),
            turns: Vec::new(),
            colouring: Colouring::Map,
            palette: Vec::new(),
            compare: false,
            view: None,
            locus: None,
            tool: Tool::Morph,
            deform: None,
            curves: None,
            directed: None,
            fit: None,
            space: None,
        }
    }
}
