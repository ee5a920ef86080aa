//! Whether the shape of an iterated function system is in one piece, over which parameters of a morph it is,
//! and how to go from one shape to another without breaking it.
//!
//! An attractor is the union of its pieces `w_i(A)`, and it is connected if and only if the graph of the pieces that
//! meet is ([`OverlapGraph`]; Hata 1985). Its *widest gap* says how far it is from that: the widest edge of the minimum
//! spanning tree of the distances between the pieces. It is zero exactly where the attractor is connected, and
//! continuous in the maps. All of the crate bounds this one number, from below and from above.
//!
#![doc = include_str!("../picture.svg")]
//!
//! # By topic
//!
//! *One system.* [`connectedness`] gives the full answer: a [`Verdict`], bounds of the gap, which pieces meet.
//! `Connected` and `Disconnected` are theorems about the maps as they are given; `Touching` says no more than that the
//! pieces come within epsilon of each other. A [`Reason`] shows the one, and a [`connected_certificate`] writes it down
//! for the crate `frond-check` to replay; a [`certificate`] shows the other: a polygon and pairs of words that are
//! apart. [`prove_exact`] does both for maps with exact numbers, such as 1/3. [`decide`] is the same in microseconds,
//! [`decide_bounds`] with bounds. [`barnsley_test`] and [`IndexBuffer`] are the tests of Burch & Hart (1997), which
//! estimate.
//!
//! *A locus.* [`LocusGrid`] samples the parameters of a [`Family`] of systems, in tiles and from coarse to fine;
//! [`LocusGrid::patch`] decides whole boxes of parameters at once. [`SingleLocus`] is the twin of the shader.
//!
//! *A path.* [`find_path`] looks for the way from (0, 0) to (1, 1) whose widest gap is least, and of such ways for one
//! with room on both sides, short and of few corners; [`plan_path`] does so on a locus that is known. Where the plane
//! has none that holds, [`Axes::Three`] lets the stretch run ahead of the turn, which often does. [`check_path`] looks
//! along a path, [`certify_path`] bounds the gap along all of it, and [`rate`] compares ways to match the maps by the
//! paths that they leave open.
//!
//! *Space.* [`connectedness3`], [`decide3`], [`locus3`] and [`find_path3`] answer the same.
//!
//! *Graph-directed systems.* [`directed_connectedness`] answers for each state, and says what it rests on;
//! [`certify_directed`] shows that the shapes of a morph stay in one piece.
//!
//! # Units
//!
//! Gaps and distances of [`connectedness`] are in units of the plane. Epsilon, and the gaps of [`Sample`],
//! [`Locus`] and [`PathPlan`], are relative to the diameter of the attractor.
//!
//! # In which order to read
//!
//! 1. `verdict`: what is asked, and the words of the answers; `overlap_graph`; `frame`: coordinates in which all maps
//!    contract and the attractor lies in the unit disc; `magnification`, for shapes too small to square their lengths.
//! 2. `support/table`: how far the attractor reaches in a direction. `gap/piece_distance` bounds the distance of two
//!    pieces by it.
//! 3. `gap/pair_descent`: which pairs of words are looked into. `gap/bracket` brackets the widest gap for `decide`,
//!    `gap/kruskal` finds out about all pairs for `connectedness`. `gap/greedy` and `gap/difference_set` are quicker
//!    ways to an answer where there is one.
//! 4. `exact` and `evidence`: proofs, in arithmetic without rounding; `evidence/meant`, about exact numbers.
//! 5. `family`, `grid` and `region`: many parameters; `region/derivative_bounds` says how far attractors move.
//! 6. `path`: `field` is the landscape, `plan` the way through it, `repair` checks it and plans again.
//! 7. `directed` asks about several shapes at once that are made of copies of each other.
//! 8. `space` does all this once more in three dimensions, `single` in f32 for the graphics card.
//!
//! # On what it stands
//!
//! - Burch & Hart, *Linear Fractal Shape Interpolation* (1997): the locus, the overlap graph, the two tests in
//!   `classic`.
//! - Hata, *On the structure of self-similar sets* (1985): connected if and only if the overlap graph is.
//! - Hutchinson, *Fractals and self similarity* (1981): a compact set that the maps take into itself holds the
//!   attractor.
//! - Bandt and others on neighbour maps: the finite graph of the ways in which pieces lie to each other
//!   (`evidence/neighbour_graph`).
//! - Calegari, Koch & Walker, *Roots, Schottky semigroups, and a proof of Bandt's conjecture* (arXiv 1410.8542): the
//!   *trap*, on which [`crossings`] rest (`region/trap`).
//! - Barnsley & Harrington, *A Mandelbrot set for pairs of linear maps* (1985): the set M ([`Polygons`]).
//! - Frank & Wolfe (1956) for nearest points of convex sets; Kruskal (1956) and Prim (1957) for spanning trees;
//!   Felzenszwalb & Huttenlocher (2012) for the distance transform.

mod classic;
mod connectedness;
mod decide;
mod directed;
mod evidence;
mod exact;
mod family;
mod frame;
mod gap;
mod grid;
mod magnification;
mod overlap_graph;
mod path;
mod region;
mod single;
mod space;
mod support;
mod verdict;

pub use classic::barnsley::{BarnsleyOptions, BarnsleyTest, Round, barnsley_test};
pub use classic::index_buffer::{Choice, IndexBuffer, IndexBufferError, IndexBufferOptions};
pub use connectedness::{Connectedness, connectedness};
pub use decide::{Scratch, decide, decide_bounds, decide_polygon};
pub use directed::certify::{DirectedCertificate, DirectedCertifyOptions, StateOnTheWay, certify_directed};
pub use directed::connectedness::{DirectedLink, StateConnectedness, directed_connectedness};
pub use directed::sample::directed_tile;
pub use evidence::certificate::{Certificate, certificate};
pub use evidence::connected_certificate::{
    CertifiedLink, ConnectedCertificate, Squares, connected_certificate,
};
pub use evidence::far_parts::Far;
pub use evidence::meant::{ExactProof, Unproved, prove_exact};
pub use evidence::reason::{Link, LinkKind, Reason};
pub use evidence::separate::Separation;
pub use family::{Drift, Family, Polygons, Slice};
pub use frond_core::along;
/// Vectors and matrices, of the version that the interface is written in.
pub use glam;
pub use grid::{Bounds, GridError, Locus, LocusGrid, Pass, Tile};
pub use overlap_graph::{Components, OverlapGraph};
pub use path::check::{PathCheck, check_path};
pub use path::plan::{PathError, PathPlan, plan_path};
pub use path::rate::{RateOptions, Rated, rate};
pub use path::search::{Axes, PathOptions, PathSearch, find_path};
pub use region::certify_path::{CertifyOptions, PathCertificate, certify_path};
pub use region::trap::{Crossing, crossings};
pub use single::{SingleError, SingleLocus, SingleMap, unpack_single};
pub use space::{
    Connectedness3, Reason3, Reason3Kind, Scratch3, Shared3, check_path3, connectedness3, decide3,
    find_path3, locus3, tile3,
};
pub use verdict::{Bounded, Ellipse, Gap, Options, ReasonKind, Sample, State, Verdict};

/// Runs the example of the README.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
