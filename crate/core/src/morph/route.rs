//! Ways to bring two shapes to a morph.

use glam::{DMat2, DVec2};

use crate::bounds::hull2::Hull;
use crate::ifs::symmetry::symmetries;
use crate::ifs::system::Ifs;
use crate::linear::affine::Affine2;
use crate::morph::correspondence2::{Costs, Frame};
use crate::morph::options::Mode;
use crate::morph::pairing::{Weighted, pair, refined, weighted};
use crate::morph::zipper::joined;

/// What a [`Route`] does.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum RouteKind {
    /// The maps as they are given, none of which has to be turned over.
    Plain,
    /// The maps as they are given, some of which collapse on the way since they have to be turned over.
    Collapse,
    /// Another matching of the maps.
    Correspondence,
    /// Maps of one shape that make the same shape, by a symmetry that it has.
    Symmetry,
    /// Towards the mirror image of the last shape.
    Mirror,
    /// A piece of one shape is split, so that both have equally many maps.
    Refine,
    /// Maps of one shape are doubled, so that both have equally many.
    Double,
    /// Pieces that join end to end in both shapes stay joined.
    Joints,
    /// The last shape lies elsewhere: turned, moved, larger or smaller.
    Place,
}

impl RouteKind {
    /// The word for it.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Plain => "plain",
            Self::Collapse => "collapse",
            Self::Correspondence => "correspondence",
            Self::Symmetry => "symmetry",
            Self::Mirror => "mirror",
            Self::Refine => "refine",
            Self::Double => "double",
            Self::Joints => "joints",
            Self::Place => "place",
        }
    }
}

/// A way to bring two shapes to a morph: maps that have the shapes for attractors, and how they are matched.
#[derive(Clone, Debug, PartialEq)]
pub struct Route {
    /// What it does.
    pub kind: RouteKind,
    /// A sentence that says what happens on it.
    pub about: String,
    /// The maps of the first shape.
    pub from: Vec<Affine2>,
    /// The maps of the last shape; of [`RouteKind::Mirror`], of its mirror image.
    pub to: Vec<Affine2>,
    /// How probable each map of `from` is. Pieces have the measure that they had; where a map is followed by a symmetry
    /// of the shape, what is within them is turned with it.
    pub from_probabilities: Vec<f64>,
    /// The same of `to`.
    pub to_probabilities: Vec<f64>,
    /// `correspondence[i]` is the map of `to` that map i of `from` becomes.
    pub correspondence: Vec<usize>,
    /// Whole extra turns of each map.
    pub turns: Vec<i32>,
    /// How the linear parts have to be interpolated; `None` where either will do.
    pub mode: Option<Mode>,
    /// The similarity that takes the last shape to where it was laid; `None` where it stays.
    pub place: Option<Affine2>,
    /// How far the maps have to move, as of [`Candidate`](crate::Candidate).
    pub cost: f64,
}

/// At most so many ways of one kind.
const MOST_OF_A_KIND: usize = 3;
/// A way must be so much cheaper than the first to be offered where that is as good in kind.
const CHEAPER_SHARE: f64 = 0.8;

/// The ways there are to bring two shapes to a morph: first what happens if nothing is chosen, then the others, the
/// plainest first.
#[must_use]
pub fn routes(from: &Ifs, to: &Ifs) -> Vec<Route> {
    let maker = Maker { frames: [Frame::of(from), Frame::of(to)] };
    let (base, mut others) =
        if from.len() == to.len() { (maker.plain(from, to), Vec::new()) } else { maker.uneven(from, to) };
    let fewer = |route: &Route, count: usize| route.overturned(&maker.frames).len() < count;
    let turned = base.overturned(&maker.frames).len();
    let matched = maker.rematched(&base);
    if matched.correspondence != base.correspondence
        && (fewer(&matched, turned) || matched.cost < CHEAPER_SHARE * base.cost)
    {
        others.push(matched);
    }
    for last in [true, false] {
        let symmetric = maker.symmetric(&base, &symmetries(if last { to } else { from }), last);
        others
            .extend(symmetric.filter(|route| fewer(route, turned) || route.cost < CHEAPER_SHARE * base.cost));
    }
    others.extend(maker.mirrored(&base, to));
    others.extend(by_joints(from, to));
    others.retain(|other| !base.is_like(other));
    others.sort_by(|a, b| a.cost.total_cmp(&b.cost));
    let mut all = vec![base];
    for other in others {
        let like = all.iter().any(|route| route.is_like(&other));
        if !like && all.iter().filter(|route| route.kind == other.kind).count() < MOST_OF_A_KIND {
            all.push(other);
        }
    }
    all
}

impl Route {
    /// Each map becomes the one of the same place, at no cost as yet.
    pub(crate) fn of(kind: RouteKind, about: String, from: Vec<Weighted>, to: Vec<Weighted>) -> Self {
        let (correspondence, turns) = ((0..from.len()).collect(), vec![0; from.len()]);
        let (from, from_probabilities) = from.into_iter().unzip();
        let (to, to_probabilities) = to.into_iter().unzip();
        Self {
            kind,
            about,
            from,
            to,
            from_probabilities,
            to_probabilities,
            correspondence,
            turns,
            mode: None,
            place: None,
            cost: 0.0,
        }
    }

    fn costs(&self, frames: &[Frame; 2]) -> Costs {
        Costs::of(&self.from, &self.to, *frames)
    }

    /// The maps that have to be turned over on the way.
    fn overturned(&self, frames: &[Frame; 2]) -> Vec<usize> {
        self.costs(frames).overturned(&self.correspondence)
    }

    pub(crate) fn is_like(&self, other: &Self) -> bool {
        self.from == other.from
            && self.to == other.to
            && self.correspondence == other.correspondence
            && self.turns == other.turns
            && self.mode == other.mode
    }
}

/// The way on which pieces that join end to end in both shapes stay joined, if there is one.
pub(crate) fn by_joints(from: &Ifs, to: &Ifs) -> Option<Route> {
    let found = joined(from, to)?;
    let maker = Maker { frames: [Frame::of(from), Frame::of(to)] };
    let count = found.from.len();
    let split = match (count > from.len(), count > to.len()) {
        (true, true) => Some("both shapes are split, so that they have"),
        (true, false) => Some("the first shape are split, so that it has"),
        (false, true) => Some("the last shape are split, so that it has"),
        (false, false) => None,
    };
    let mut about =
        "Each piece joins the next by an end, in both shapes, and all joints stay joined.".to_owned();
    about.push_str(&split.map_or(String::new(), |split| format!(" Pieces of {split} {count} maps.")));
    about.push_str(&found.place.map_or(String::new(), laid));
    let route = maker.route(RouteKind::Joints, about, found.from, found.to);
    Some(Route { mode: Some(Mode::Linear), place: found.place, ..route })
}

/// Where the last shape was laid, in a sentence to be said after something else.
pub(crate) fn laid(place: Affine2) -> String {
    let along = place.linear.x_axis;
    let (scale, degrees) = (along.length(), along.to_angle().to_degrees().round());
    let mut done = Vec::new();
    if degrees != 0.0 {
        // Half a turn is one either way; a minus is as wide as a plus.
        let degrees = if degrees == -180.0 { 180.0 } else { degrees };
        done.push(format!("turned by {degrees:.0}\u{b0}").replace('-', "\u{2212}"));
    }
    if (scale - 1.0).abs() > 0.005 {
        done.push(format!("{scale:.2} times as large"));
    }
    let done = if done.is_empty() { "moved".to_owned() } else { done.join(" and ") };
    format!(" The last shape lies elsewhere, {done}.")
}

struct Maker {
    frames: [Frame; 2],
}

impl Maker {
    fn route(&self, kind: RouteKind, about: String, from: Vec<Weighted>, to: Vec<Weighted>) -> Route {
        let mut route = Route::of(kind, about, from, to);
        self.price(&mut route);
        route
    }

    fn price(&self, route: &mut Route) {
        let costs = route.costs(&self.frames);
        route.cost = costs.candidate(route.correspondence.clone(), route.turns.clone()).cost;
    }

    /// What happens on the way to the pieces that have to be turned over, to be said after something else.
    fn collapse(&self, route: &Route) -> String {
        let names: Vec<String> = route.overturned(&self.frames).iter().map(|i| (i + 1).to_string()).collect();
        match &names[..] {
            [] => String::new(),
            [one] => format!(" Piece {one} has to be turned over, and is flat for a moment on the way."),
            [first @ .., last] => format!(
                " Pieces {} and {last} have to be turned over, and are flat for a moment on the way.",
                first.join(", ")
            ),
        }
    }

    fn plain(&self, from: &Ifs, to: &Ifs) -> Route {
        let mut route = self.route(RouteKind::Plain, String::new(), weighted(from), weighted(to));
        let collapse = self.collapse(&route);
        if collapse.is_empty() {
            route.about = "Each piece turns, stretches and moves into the one of the same number.".to_owned();
        } else {
            route.kind = RouteKind::Collapse;
            collapse.trim_start().clone_into(&mut route.about);
        }
        route
    }

    /// The same maps, matched anew so that as few as can be are turned over, and they move as little as can be.
    fn rematched(&self, base: &Route) -> Route {
        let costs = base.costs(&self.frames);
        let correspondence = costs.best();
        let mut route = Route { kind: RouteKind::Correspondence, correspondence, ..base.clone() };
        self.price(&mut route);
        let spared = base.overturned(&self.frames).len() > route.overturned(&self.frames).len();
        let collapse = self.collapse(&route);
        route.about = match (spared, collapse.is_empty()) {
            (true, true) => {
                "The pieces are matched in another order, so that none has to be turned over.".to_owned()
            }
            (true, false) => {
                format!(
                    "The pieces are matched in another order, so that fewer have to be turned over.{collapse}"
                )
            }
            (false, _) => {
                format!(
                    "The pieces are matched in another order, so that they have less far to go.{collapse}"
                )
            }
        };
        route
    }

    /// The maps of one end followed by symmetries of its shape, for each map the one that is least work; and where
    /// none has to be turned over as it is, the same with reflections left out.
    fn symmetric(&self, base: &Route, group: &[Affine2], last: bool) -> impl Iterator<Item = Route> + use<> {
        let which = if last { "last" } else { "first" };
        let mut found = Vec::new();
        let mirrors = group.iter().any(|sigma| sigma.determinant() < 0.0);
        // In the order given, and matched anew.
        for start in [base.clone(), self.rematched(base)] {
            if group.len() < 2 {
                break;
            }
            let mut route = Route { kind: RouteKind::Symmetry, ..start };
            for i in 0..route.from.len() {
                let (a, b) = (route.from[i], route.to[route.correspondence[i]]);
                let work = |sigma: &Affine2| {
                    let ends = if last { (a, b * *sigma) } else { (a * *sigma, b) };
                    let costs = Costs::of(&[ends.0], &[ends.1], self.frames);
                    let over = costs.overturned(&[0]).len() as f64;
                    costs.candidate(vec![0], vec![0]).cost + 10.0 * over
                };
                // The first of the least, and the identity comes first.
                let (mut sigma, mut least) = (Affine2::IDENTITY, work(&Affine2::IDENTITY));
                for other in group {
                    let tried = work(other);
                    if tried < least - 1e-9 {
                        (sigma, least) = (*other, tried);
                    }
                }
                if sigma == Affine2::IDENTITY {
                    continue;
                }
                if last {
                    route.to[route.correspondence[i]] = b * sigma;
                } else {
                    route.from[i] = a * sigma;
                }
            }
            self.price(&mut route);
            let sound = |maps: &[Affine2]| Ifs::new(maps.to_vec()).is_ok();
            let changed = route.from != base.from || route.to != base.to;
            if !(changed && sound(&route.from) && sound(&route.to)) {
                continue;
            }
            let spared = base.overturned(&self.frames).len() > route.overturned(&self.frames).len();
            let alike = if mirrors && spared {
                "looks the same in a mirror, so some of its pieces may be drawn the other way round and need not be turned over"
            } else {
                "looks the same from several sides, so some of its pieces may be turned in themselves and have less far to turn"
            };
            route.about = format!("The {which} shape {alike}.{}", self.collapse(&route));
            found.push(route);
        }
        // The better of the two.
        found.into_iter().min_by(|a, b| a.cost.total_cmp(&b.cost)).into_iter()
    }

    /// Towards the mirror image of the last shape, unless that is the shape itself.
    fn mirrored(&self, base: &Route, to: &Ifs) -> Option<Route> {
        if symmetries(to).iter().any(|sigma| sigma.determinant() < 0.0) {
            return None;
        }
        let centre = Hull::of(to).centre();
        let mirror = DMat2::from_diagonal(DVec2::new(-1.0, 1.0));
        let mirror = Affine2::new(mirror, centre - mirror * centre);
        let to: Option<Vec<Affine2>> = base.to.iter().map(|map| map.conjugate(mirror)).collect();
        let (correspondence, turns) = ((0..base.to.len()).collect(), vec![0; base.to.len()]);
        let about =
            "The last shape is shown in a mirror: it is the same shape, but the pieces turn other ways.";
        let mut plain = Route { to: to?, correspondence, turns, ..base.clone() };
        self.price(&mut plain);
        // The mirror exchanges left and right, so the order that suited the shape may not suit its image.
        let matched = self.rematched(&plain);
        let mut route = if matched.cost < CHEAPER_SHARE * plain.cost { matched } else { plain };
        route.kind = RouteKind::Mirror;
        route.about = format!("{about}{}", self.collapse(&route));
        Some(route)
    }

    /// Unequal numbers of maps: what [`pair`] does, and each map that could be split or doubled instead.
    fn uneven(&self, from: &Ifs, to: &Ifs) -> (Route, Vec<Route>) {
        let first = from.len() < to.len();
        let (few, many, which) = if first { (from, to, "first") } else { (to, from, "last") };
        let missing = many.len() - few.len();
        let paired = pair(from, to);
        // Pairs that need any splitting count as refined.
        let kind =
            if missing >= few.len() - 1 && few.len() > 1 { RouteKind::Refine } else { RouteKind::Double };
        let [own, other] = [(paired.from, paired.from_probabilities), (paired.to, paired.to_probabilities)]
            .map(|(maps, probabilities)| maps.into_iter().zip(probabilities).collect());
        let mut base = self.route(kind, paired.steps.join(" "), own, other);
        base.about.push_str(&self.collapse(&base));
        let (few, many) = (weighted(few), weighted(many));
        let matched = |maps: Vec<Weighted>, kind: RouteKind, about: String| {
            let (from, to) = if first { (maps, many.clone()) } else { (many.clone(), maps) };
            let mut route = self.route(kind, about, from, to);
            route.correspondence = route.costs(&self.frames).best();
            self.price(&mut route);
            route.about.push_str(&self.collapse(&route));
            route
        };
        let mut others = Vec::new();
        for k in 0..few.len() {
            if few.len() > 1 && missing == few.len() - 1 {
                let about =
                    format!("Piece {} of the {which} shape is split into its {} parts.", k + 1, few.len());
                others.push(matched(refined(&few, &few, k), RouteKind::Refine, about));
            }
            if missing == 1 {
                let mut maps = few.clone();
                maps[k].1 /= 2.0;
                maps.push(maps[k]);
                let about =
                    format!("Piece {} of the {which} shape counts twice, and comes apart into two.", k + 1);
                others.push(matched(maps, RouteKind::Double, about));
            }
        }
        // The same maps in another order are the same way.
        let sorted = |route: &Route| {
            let mut pairs: Vec<[u64; 12]> = (0..route.from.len())
                .map(|i| {
                    let (a, b) = (route.from[i].to_row(), route.to[route.correspondence[i]].to_row());
                    std::array::from_fn(|k| if k < 6 { a[k] } else { b[k - 6] }.to_bits())
                })
                .collect();
            pairs.sort_unstable();
            pairs
        };
        let known = sorted(&base);
        others.retain(|other| sorted(other) != known);
        (base, others)
    }
}
