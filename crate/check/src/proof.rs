//! Certificates of both kinds.

use std::fmt;

use crate::certificate::Certificate;
use crate::connected::ConnectedCertificate;
use crate::joined::{CheckedConnected, check_connected_within};
use crate::refused::Refused;
use crate::replay::{Checked, check_within};
use crate::work::{WORK, Work};

/// A certificate of either kind.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Proof {
    /// The attractor is in several pieces.
    Disconnected(Certificate),
    /// It is in one.
    Connected(ConnectedCertificate),
}

/// What was checked of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CheckedProof {
    /// The attractor is in several pieces.
    Disconnected(Checked),
    /// It is in one.
    Connected(CheckedConnected),
}

impl Proof {
    /// Checks it in exact arithmetic.
    ///
    /// # Errors
    /// As [`check`](crate::check) and [`check_connected`](crate::check_connected).
    pub fn check(&self) -> Result<CheckedProof, Refused> {
        self.check_within(&Work::at_most(WORK))
    }

    /// The same with a meter of its own, which a certificate of any kind is given.
    pub(crate) fn check_within(&self, work: &Work) -> Result<CheckedProof, Refused> {
        match self {
            Self::Disconnected(certificate) => {
                check_within(certificate, work).map(CheckedProof::Disconnected)
            }
            Self::Connected(certificate) => {
                check_connected_within(certificate, work).map(CheckedProof::Connected)
            }
        }
    }
}

impl fmt::Display for CheckedProof {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Disconnected(checked) => checked.fmt(f),
            Self::Connected(checked) => checked.fmt(f),
        }
    }
}
