//! From an outline to its formula: fractal functions and curves, and how they are fitted.
//!
//! After Cochran, Hart and Flynn, "On Approximating Rough Curves With Fractal Functions", and beyond it.
//!
#![doc = include_str!("../picture.svg")]
//!
//! - [`FractalFunction`] and [`FractalCurve`] are made of smaller copies of parts of themselves: FIF, where each piece
//!   copies the whole; RFIF, where it copies what lies between two knots; PFIF, where it copies any part.
//! - [`Hough`] finds maps that a graph is made of by voting; [`name_clusters`] tells maps from echoes, [`assemble`]
//!   makes a whole function of them, [`assemble_within`] the shortest that is nowhere farther off than a tolerance,
//!   [`assemble_picked`] one of those that were picked, [`FractalFunction::to_recurrent`] a RFIF of a PFIF. A
//!   [`Series`] is measured data, [`Components`] the directions in which clusters spread.
//! - [`fit_collage`] is the paper's fit of a ring of feature points.
//! - [`Fitter`] fits a [`ClosedCurve`], knots with edges that are straight or copies of arcs, which is closed by
//!   construction, no farther from the outline than the best polyline of as many numbers, and crosses itself nowhere
//!   that the outline does not.
//! - [`fit_within`] fits a [`Spline`] of corners and parabolas on a grid within so many bytes.
//! - [`CurveMorph`] brings two closed curves to one structure; at every moment between them there is a closed curve.
//! - [`Outline`] is a closed polyline that is to be fitted; [`features`] finds its feature points, [`fidelity`] says
//!   how near a fit is to it.
//! - [`Tracer`] finds the leaf in a picture and the line round it, [`read_file`] outlines and series in drawings and
//!   tables.
//! - [`split_polyline`], [`least_squares_polyline`], [`bezier`] and [`fourier`] spend as many numbers in other ways;
//!   [`polyline_within`], [`bezier_within`] and [`fourier_within`] as many bytes;
//!   [`maple_leaf`], [`oak_leaf`], [`sugar_maple`], [`white_oak`] and [`island`] grow outlines to try all this on;
//!   [`curve_presets`] are fits of some of them.
//!
//! # In which order to read it
//!
//! 1. `outline`: what is fitted, its corners and feature points, and how near a fit is to it.
//! 2. `fractal`: a piece, the curves and functions that are made of pieces, and points of them.
//! 3. `collage` and `hough`: the paper's two ways to find the pieces. `baseline`: what they are compared with.
//! 4. `closed`: the form that does better. `fitting`: how it is found. `fitter` is the loop, `straight` the polyline
//!    that it begins with; `search` trades numbers between knots and copies: `candidates` proposes copies, `choice`
//!    says which `moves` are made, `refine` is least squares through the attractor (`normal` solves them);
//!    `final_refine` ends it, `judge` keeps what is no worse than the polyline.
//!    `spline`: another form, of corners and parabolas, and its fit within so many bytes.
//! 5. `curve_morph`: two curves matched by dynamic time warping (`dtw`), given as many knots each (`matching`,
//!    `knot_ring`).
//! 6. `segment`: a leaf in a picture. A channel, Otsu's threshold, morphology, connected components, the contour; where
//!    the ground has shade on it, colours and a random walk.
//!    `read`: outlines and series out of files. `series`: a series, smoothed and brought to few points.
//! 7. `grown`: leaves that a program grows, to try all this on. `preset`: closed curves to begin with.
//!
//! # What it stands on
//!
//! - Cochran, Hart and Flynn (above): fractal functions, the collage fit, the votes.
//! - Barnsley, "Fractal functions and interpolation" (1986): FIF.
//! - Otsu, "A threshold selection method from gray-level histograms" (1979): `segment`.
//! - Ottosson, "A perceptual color space for image processing" (2020); Rother, Kolmogorov and Blake, "GrabCut" (2004);
//!   Grady, "Random walks for image segmentation" (2006); Criminisi, Sharp and Blake, "GeoS" (2008): leaf and shadow.
//! - Sakoe and Chiba, "Dynamic programming algorithm optimization for spoken word recognition" (1978): `dtw`.
//!
//! Conventions: y points up, outlines run counter-clockwise, indices count from 0 in code and from 1 in messages.
//! No panics on any input, no unsafe code, no web, no pictures.

mod baseline;
mod closed;
mod collage;
mod curve_morph;
mod error;
mod fitting;
mod fractal;
mod grown;
mod hough;
mod outline;
mod preset;
mod read;
mod segment;
mod series;
mod spline;

pub use baseline::{
    bezier, bezier_segments, bezier_within, fourier, fourier_within, least_squares_polyline, polyline_within,
    split_polyline,
};
pub use closed::{
    ArcCopy, CONTRACTION, ClosedCurve, CopyFacts, CurveFault, MAX_KNOTS, MAX_SPAN, MAX_TEXT, PackError,
};
pub use collage::{Bounding, CollageError, CollageFit, CollageOptions, Domains, RingMap, fit_collage};
pub use curve_morph::{CurveMorph, MAX_FILE_POINTS, MorphError, MorphedCurve};
pub use error::{FunctionError, MAX_POINTS};
pub use fitting::{
    ClosedFit, DRAWING_LEVELS, DRAWING_TOLERANCE, FitError, Fitter, Progress, Stage, partition,
};
pub use fractal::curve::{FractalCurve, Side};
pub use fractal::function::{Dimension, FractalFunction};
pub use fractal::piece::{Piece, spectral_norm};
pub use fractal::recurrent::Recurrent;
/// Vectors and matrices, of the version that the interface is written in.
pub use glam;
pub use grown::{island, maple_leaf, noisy, oak_leaf, sugar_maple, white_oak};
pub use hough::{
    Assembly, BINS, Candidate, Cluster, Components, Features, FirstPass, Found, Hough, HoughError,
    HoughOptions, HoughProgress, Kind, Letter, MAX_CELLS, MAX_FEATURES, Model, PLANE, Pick, SecondPass,
    Within, assemble, assemble_picked, assemble_within, gather, in_range, name_clusters, refine_map,
    share_cells,
};
pub use outline::{
    Fidelity, Guard, MAX_OUTLINE, MAX_PREPARED, Near, Nearest, Outline, OutlineError, box_slope, contacts,
    crossings, decimated, features, fidelity,
};
pub use preset::{CurvePreset, curve_preset, curve_presets};
#[cfg(feature = "svg")]
pub use read::read_drawing;
pub use read::{FileContent, FileKind, NamedOutline, ReadAs, ReadError, Remark, read_file, sniff};
pub use segment::{
    Channel, Component, MAX_PIXELS, Mask, MaskOptions, Notice, Stroke, Surround, TraceError, Traced, Tracer,
};
pub use series::Series;
pub use spline::{
    LEAST_BYTES, MAX_NODES, MOST_BYTES, Node, Spline, SplineError, SplineFit, SplineFitter, StepLaw,
    fit_within,
};

/// Runs the example of the README.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
