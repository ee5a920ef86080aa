//! Which texts there are.

use thiserror::Error;

use super::{aifs, csv, desmos, flame, fractint, geogebra, json, latex, python, svg, tikz};
use crate::system::{Maps, System};

/// A form in which maps are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ExportFormat {
    /// As the programming interface has them.
    Json,
    /// For Fractint and many others.
    Fractint,
    /// For flam3, Apophysis and others: linear.
    Flame,
    /// A program for IFStile.
    Aifs,
    /// Matrices for a paper.
    Latex,
    /// A figure for a paper.
    Tikz,
    /// A program that draws the shape with NumPy and Matplotlib.
    Python,
    /// A command for GeoGebra.
    Geogebra,
    /// Expressions for Desmos.
    Desmos,
    /// A drawing.
    Svg,
    /// A table.
    Csv,
}

impl ExportFormat {
    /// All of them, the most asked for first.
    pub const ALL: [Self; 11] = [
        Self::Json,
        Self::Fractint,
        Self::Flame,
        Self::Aifs,
        Self::Csv,
        Self::Svg,
        Self::Latex,
        Self::Tikz,
        Self::Python,
        Self::Geogebra,
        Self::Desmos,
    ];

    /// A name that stays the same over versions, for programs.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::Json => "json",
            Self::Fractint => "fractint",
            Self::Flame => "flame",
            Self::Aifs => "aifs",
            Self::Latex => "latex",
            Self::Tikz => "tikz",
            Self::Svg => "svg",
            Self::Python => "python",
            Self::Geogebra => "geogebra",
            Self::Desmos => "desmos",
            Self::Csv => "csv",
        }
    }

    /// How it is called.
    #[must_use]
    pub const fn label(self) -> &'static str {
        match self {
            Self::Json => "JSON",
            Self::Fractint => "Fractint",
            Self::Flame => "Flame",
            Self::Aifs => "AIFS",
            Self::Latex => "LaTeX",
            Self::Tikz => "TikZ",
            Self::Svg => "SVG",
            Self::Python => "Python",
            Self::Geogebra => "GeoGebra",
            Self::Desmos => "Desmos",
            Self::Csv => "CSV",
        }
    }

    /// A sentence about it.
    #[must_use]
    pub const fn about(self) -> &'static str {
        match self {
            Self::Json => "For Frond, which opens it again, and for programs. Every bit is kept.",
            Self::Fractint => "For Fractint and many other programs; opens here again. Every bit is kept.",
            Self::Flame => "For Apophysis, flam3 and their like; opens here again. Every bit is kept.",
            Self::Aifs => "For IFStile, which finds dimensions and boundaries of tiles; opens here again.",
            Self::Latex => "The maps as matrices, for a paper. Needs amsmath.",
            Self::Svg => "A drawing of up to ten thousand pieces, for Inkscape, Illustrator and their like.",
            Self::Tikz => "A figure for a paper, of a thousand pieces or so.",
            Self::Python => "Runs as it stands and draws the shape, with NumPy and Matplotlib.",
            Self::Geogebra => "Paste it into the input bar of GeoGebra: it makes points of the shape.",
            Self::Desmos => "Paste it into an empty expression of Desmos: it makes points of the shape.",
            Self::Csv => "A table for spreadsheets; opens here again. Every bit is kept.",
        }
    }

    /// How names of such files end.
    #[must_use]
    pub const fn extension(self) -> &'static str {
        match self {
            Self::Json => "json",
            Self::Fractint => "ifs",
            Self::Flame => "flame",
            Self::Aifs => "aifs",
            Self::Latex | Self::Tikz => "tex",
            Self::Python => "py",
            Self::Svg => "svg",
            Self::Geogebra | Self::Desmos => "txt",
            Self::Csv => "csv",
        }
    }

    /// Whether maps of space can be written so.
    #[must_use]
    pub const fn takes_space(self) -> bool {
        matches!(self, Self::Json | Self::Fractint | Self::Aifs | Self::Csv | Self::Latex | Self::Python)
    }

    /// The form with this name.
    #[must_use]
    pub fn by_id(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|format| format.id() == id)
    }
}

/// Why maps cannot be written.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum ExportError {
    /// There are none.
    #[error("There are no maps to write. Add at least one.")]
    Nothing,
    /// A number is not finite.
    #[error("A number of the maps is not finite, and no file holds such. Mend it first.")]
    NotFinite,
    /// The probabilities are not those of the maps.
    #[error(
        "The probabilities are not one number for each map, none of them negative, with a finite sum. Mend them, or \
         leave them out."
    )]
    Weights,
    /// The form is one of the plane.
    #[error(
        "{format} is written of maps of the plane alone. Choose JSON, Fractint, AIFS, CSV, LaTeX or Python."
    )]
    OfPlane {
        /// What was asked for.
        format: &'static str,
    },
    /// The form is one of systems of one state.
    #[error("{format} is written of systems of one state alone. Choose AIFS.")]
    OneState {
        /// What was asked for.
        format: &'static str,
    },
    /// A figure needs an attractor.
    #[error("These maps have no attractor that could be drawn. Make them smaller, or choose another form.")]
    NoAttractor,
}

impl ExportError {
    /// A name that stays the same over versions, for programs.
    #[must_use]
    pub const fn code(&self) -> &'static str {
        match self {
            Self::Nothing => "export-nothing",
            Self::NotFinite => "export-not-finite",
            Self::Weights => "export-weights",
            Self::OfPlane { .. } => "export-plane-only",
            Self::OneState { .. } => "export-one-state",
            Self::NoAttractor => "no-attractor",
        }
    }
}

/// Writes the maps of a system.
///
/// # Errors
/// Where there are none, a number is not finite, the probabilities are not those of the maps, or the form is one of the
/// plane alone.
pub fn export(system: &System, format: ExportFormat) -> Result<String, ExportError> {
    if system.maps.is_empty() {
        return Err(ExportError::Nothing);
    }
    if !system.maps.rows().into_iter().flatten().chain(&system.probabilities).all(|x| x.is_finite()) {
        return Err(ExportError::NotFinite);
    }
    if !system.has_sound_weights() {
        return Err(ExportError::Weights);
    }
    match (format, &system.maps) {
        (ExportFormat::Aifs, _) => Ok(aifs::write(system)),
        (format, Maps::Directed(_) | Maps::Objects(_)) => {
            Err(ExportError::OneState { format: format.label() })
        }
        (ExportFormat::Json, _) => Ok(json::write(system)),
        (ExportFormat::Fractint, _) => Ok(fractint::write(system)),
        (ExportFormat::Csv, _) => Ok(csv::write(system)),
        (ExportFormat::Latex, _) => Ok(latex::write(system)),
        (ExportFormat::Python, _) => Ok(python::write(system)),
        (ExportFormat::Flame, Maps::Plane(rows)) => Ok(flame::write(system, rows)),
        (ExportFormat::Geogebra, Maps::Plane(rows)) => Ok(geogebra::write(rows)),
        (ExportFormat::Desmos, Maps::Plane(rows)) => Ok(desmos::write(rows)),
        (ExportFormat::Tikz, Maps::Plane(rows)) => tikz::write(system, rows).ok_or(ExportError::NoAttractor),
        (ExportFormat::Svg, Maps::Plane(rows)) => svg::write(system, rows).ok_or(ExportError::NoAttractor),
        (format, Maps::Space(_)) => Err(ExportError::OfPlane { format: format.label() }),
    }
}
