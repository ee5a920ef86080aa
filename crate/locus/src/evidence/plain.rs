//! Certificates as those who check them read them.

use frond_check::{Address, Far, Link, Pair};

use crate::evidence::certificate::Certificate;
use crate::evidence::connected_certificate::{CertifiedLink, ConnectedCertificate};

impl From<Certificate> for frond_check::Certificate {
    fn from(found: Certificate) -> Self {
        Self {
            maps: found.maps,
            polygon: found.polygon.iter().map(glam::DVec2::to_array).collect(),
            letters: found.letters,
            side: found.side,
            pairs: found
                .pairs
                .into_iter()
                .map(|pair| Pair { u: pair.u, v: pair.v, normal: pair.normal.to_array() })
                .collect(),
            exact: None,
        }
    }
}

impl From<CertifiedLink> for Link {
    fn from(link: CertifiedLink) -> Self {
        match link {
            CertifiedLink::Point(addresses) => {
                Self::Point { addresses: addresses.map(|[head, repeat]| Address { head, repeat }) }
            }
            CertifiedLink::Between(addresses) => {
                Self::Between { addresses: addresses.map(|[head, repeat]| Address { head, repeat }) }
            }
            CertifiedLink::Area(pair) => Self::Area { pair },
            CertifiedLink::Difference(pair, steps) => Self::Difference { pair, steps },
            CertifiedLink::Crossing(words, far) => Self::Crossing {
                words,
                far: far.map(|far| Far { tail: far.tail, direction: far.direction.to_array() }),
            },
        }
    }
}

impl From<ConnectedCertificate> for frond_check::ConnectedCertificate {
    fn from(found: ConnectedCertificate) -> Self {
        Self {
            maps: found.maps,
            polygon: found.polygon.iter().map(glam::DVec2::to_array).collect(),
            gap: found.gap,
            near: found.near,
            links: found.links.into_iter().map(Into::into).collect(),
            squares: found.squares.map(|squares| frond_check::Squares {
                size: squares.size.to_array(),
                cells: squares.cells.into_iter().map(|([x, y], [k, l])| (x, y, k, l)).collect(),
            }),
            exact: None,
        }
    }
}
