//! Whether coordinates are degrees of the globe, or pixels or millimetres: what the numbers and the file say.

use glam::DVec2;

/// A system of coordinates that a file names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Crs {
    /// Longitudes and latitudes.
    Degrees,
    /// Lengths on a plane.
    Plane,
}

/// Codes have as many digits; shorter numbers are of versions.
const SHORTEST_CODE: usize = 4;

impl Crs {
    /// What a name such as `urn:ogc:def:crs:EPSG::28992` says; None where it says nothing that is known.
    pub fn of(name: &str) -> Option<Self> {
        let name = name.to_ascii_uppercase();
        if ["CRS84", "CRS:84", "WGS84", "WGS 84"].iter().any(|globe| name.contains(globe)) {
            // Behind the name of the globe stands that of a projection.
            return Some(if name.contains(" / ") || name.contains("UTM") {
                Self::Plane
            } else {
                Self::Degrees
            });
        }
        let code = match name.find("EPSG").or_else(|| name.find("ESRI")) {
            Some(at) => &name[at..],
            None if name.bytes().all(|byte| byte.is_ascii_digit()) => &name,
            None => return None,
        };
        let digits = code.split(|c: char| !c.is_ascii_digit()).find(|part| part.len() >= SHORTEST_CODE)?;
        let code: u32 = digits.parse().ok()?;
        // The codes of systems of longitude and latitude, with few exceptions.
        let degrees = (4000..5000).contains(&code) || [7844, 7843, 9000, 8246, 10_177].contains(&code);
        Some(if degrees { Self::Degrees } else { Self::Plane })
    }
}

/// What is known of the coordinates of a file.
#[derive(Clone, Debug)]
pub struct Evidence {
    low: DVec2,
    high: DVec2,
    /// Whether none has more than two decimals.
    coarse: bool,
    pub crs: Option<Crs>,
    /// Whether the program that wrote them draws on pictures.
    pub picture: bool,
    /// Whether there were rows of more numbers than a position has.
    pub long: bool,
}

impl Default for Evidence {
    fn default() -> Self {
        let (low, high) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
        Self { low, high, coarse: true, crs: None, picture: false, long: false }
    }
}

/// What coordinates are taken for, and why.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Units {
    /// Degrees: the file says so, or nothing else.
    Degrees,
    /// Lengths: the file says so, or they are too large for degrees.
    Lengths,
    /// Lengths, though the file does not say so: degrees would not look so.
    Guessed,
    /// Pixels, with y downwards.
    Pixels,
}

/// What has a side as short as that, in degrees, is no picture.
const SMALLEST_PICTURE: f64 = 10.0;

impl Evidence {
    pub fn take(&mut self, p: DVec2) {
        (self.low, self.high) = (self.low.min(p), self.high.max(p));
        let hundredths = 100.0 * p;
        self.coarse &= (hundredths - hundredths.round()).abs().max_element() < 1e-6;
    }

    pub fn absorb(&mut self, later: &Self, counts: bool) {
        self.crs = self.crs.or(later.crs);
        self.picture |= later.picture;
        self.long |= later.long;
        if counts {
            (self.low, self.high) = (self.low.min(later.low), self.high.max(later.high));
            self.coarse &= later.coarse;
        }
    }

    /// What the coordinates are taken for. `bare` is a list of points without any words.
    pub fn units(&self, bare: bool) -> Units {
        let within =
            self.low.cmpge(DVec2::new(-360.0, -90.0)).all() && self.high.cmple(DVec2::new(360.0, 90.0)).all();
        if self.picture {
            return Units::Pixels;
        }
        match self.crs {
            _ if !within => return Units::Lengths,
            Some(Crs::Plane) => return Units::Lengths,
            Some(Crs::Degrees) => return Units::Degrees,
            None if bare => return Units::Lengths,
            None => {}
        }
        // Pictures begin at a corner, and their numbers are short. Countries that lie so lie on the equator, where
        // little is lost.
        let size = self.high - self.low;
        let positive = self.low.min_element() >= 0.0;
        let at_corner = positive && self.low.cmple(size).all();
        let short = positive && self.coarse && size.min_element() >= SMALLEST_PICTURE;
        if at_corner || short { Units::Guessed } else { Units::Degrees }
    }

    /// By how much degrees of longitude are shorter than those of latitude, in the middle.
    pub fn factor(&self) -> f64 {
        (0.5 * (self.low.y + self.high.y)).to_radians().cos().max(0.01)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_systems_are_known() {
        for (name, wanted) in [
            ("urn:ogc:def:crs:OGC:1.3:CRS84", Some(Crs::Degrees)),
            ("urn:ogc:def:crs:EPSG::4326", Some(Crs::Degrees)),
            ("EPSG:4258", Some(Crs::Degrees)),
            ("urn:ogc:def:crs:EPSG::28992", Some(Crs::Plane)),
            ("EPSG:3857", Some(Crs::Plane)),
            ("http://www.opengis.net/def/crs/EPSG/0/25832", Some(Crs::Plane)),
            ("WGS 84 / UTM zone 33N", Some(Crs::Plane)),
            ("WGS 84 / Pseudo-Mercator", Some(Crs::Plane)),
            ("urn:ogc:def:crs:EPSG:7.9:4326", Some(Crs::Degrees)),
            ("http://spatialreference.org/ref/epsg/4326/proj4/", Some(Crs::Degrees)),
            ("28992", Some(Crs::Plane)),
            ("", None),
            ("local", None),
        ] {
            assert_eq!(Crs::of(name), wanted, "{name}");
        }
    }

    #[test]
    fn units_follow_from_what_is_known() {
        let units = |low: [f64; 2], high: [f64; 2]| {
            let mut evidence = Evidence::default();
            evidence.take(DVec2::from(low));
            evidence.take(DVec2::from(high));
            evidence.units(false)
        };
        // Germany, Chile, New Zealand, Iceland with few decimals.
        for (low, high) in [
            ([5.8663, 47.2701], [15.0419, 55.0992]),
            ([-75.644, -55.611], [-66.959, -17.580]),
            ([166.5, -46.6], [178.5, -34.4]),
            ([0.0, 60.0], [2.0, 61.0]),
        ] {
            assert_eq!(units(low, high), Units::Degrees, "{low:?}");
        }
        for (low, high) in
            [([0.0, 0.0], [60.0, 60.0]), ([1.4417, 2.0], [44.6001, 86.0]), ([100.0, 40.0], [130.0, 70.0])]
        {
            assert_eq!(units(low, high), Units::Guessed, "{low:?}");
        }
        assert_eq!(units([0.0, 0.0], [20.0, 91.0]), Units::Lengths);
    }
}
