//! Whether the shape of an iterated function system is in one piece, over which parameters of a morph it is,
//! and how to go from one shape to another without breaking it.
//!
//! An attractor is the union of its pieces `w_i(A)`, and it is connected if and only if the graph of the
//! pieces that meet is ([`OverlapGraph`]; Hata 1985, Burch & Hart 1997, theorem 2). Three tests find that
//! graph:
//!
//! - [`barnsley_test`] compares points of the pieces with a bound of their error (Burch & Hart, Fig 1);
//! - [`IndexBuffer`] looks for pieces that were plotted in one pixel (their Fig 2);
//! - [`connectedness`] descends on pairs of words and bounds the pieces that they name by the support function of the
//!   attractor. It proves, where the others estimate: a [`Verdict`] of `Disconnected` or `Connected` is a
//!   theorem about the maps, and `Touching` says no more than that the pieces come within epsilon of each
//!   other. It measures the widest gap, too: the widest edge of the minimum spanning tree of the distances
//!   between pieces, which is zero exactly where the attractor is connected, and continuous in the maps.
//!
//! Both verdicts come with what shows them. A [`Reason`] is a point that pieces share, given by its addresses and
//! checked in whole numbers of any length, or pieces that cross, or a finite graph of neighbours; where numbers only
//! come near to those that it needs (1/3, sqrt(3)/6), it says so, and the verdict stays `Touching`. A [`certificate`]
//! of disconnection is a polygon and pairs of words that are apart, for the crate `frond-check` to replay.
//!
//! [`decide`] is the same in microseconds, for one parameter of a locus; [`LocusGrid`] samples a locus with
//! it, in tiles and from coarse to fine; [`plan_path`] and [`find_path`] look for the way from (0, 0) to
//! (1, 1) whose widest gap is least, and of such ways for one with room on both sides, short and of few corners.
//! Where the plane has none that holds, [`Axes::Three`] lets the stretch run ahead of the turn, which often
//! does; and [`rate`] compares ways to match the maps by the paths that they leave open.
//!
//! What holds at one parameter often holds around it, and that is proved as well: [`LocusGrid::patch`] decides whole
//! boxes of a [`Family`] at once, [`certify_path`] bounds the gap along all of a path, and [`crossings`] are a reason
//! to be connected that survives small changes.
//!
//! In space [`connectedness3`], [`decide3`], [`locus3`] and [`find_path3`] answer the same.
//!
//! Gaps and distances of [`connectedness`] are in units of the plane. Epsilon, and the gaps of [`Sample`],
//! [`Locus`] and [`PathPlan`], are relative to the diameter of the attractor.

mod classic;
mod connectedness;
mod decide;
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
pub use evidence::certificate::{Certificate, certificate};
pub use evidence::reason::{Link, LinkKind, Reason};
pub use evidence::separate::Separation;
pub use family::{Drift, Family, Polygons, Slice};
pub use frond_core::along;
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
    find_path3, locus3,
};
pub use verdict::{Bounded, Ellipse, Gap, Options, ReasonKind, Sample, State, Verdict};
