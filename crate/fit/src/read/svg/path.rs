//! The words of paths: read one command at a time, so that a path of any length takes no memory.

use kurbo::{PathEl, Point, Vec2};

/// Where the elements of a path go.
pub type Sink<'a> = &'a mut dyn FnMut(PathEl);

/// Sends what a path says to `sink`, in absolute places and without arcs. What follows a mistake is not drawn, as
/// browsers do; whether there was none is returned.
pub fn path(data: &str, sink: Sink<'_>) -> bool {
    let mut words = Words { bytes: data.as_bytes(), text: data, at: 0 };
    let mut pen =
        Pen { sink, at: Point::ORIGIN, start: Point::ORIGIN, control: None, moved: None, begun: false };
    let mut command = 0;
    loop {
        match words.peek() {
            None => return true,
            Some(letter) if letter.is_ascii_alphabetic() => {
                words.at += 1;
                command = letter;
            }
            // Numbers alone go on with the last command.
            Some(_) if command == 0 => return false,
            Some(_) => {}
        }
        if pen.command(command, &mut words).is_none() {
            return false;
        }
        command = match command {
            b'M' => b'L',
            b'm' => b'l',
            // Nothing goes on after the end of a line.
            b'Z' | b'z' => 0,
            other => other,
        };
    }
}

/// Sends the corners of a list of numbers to `sink`; whether there was no mistake.
pub fn corners(list: &str, closed: bool, sink: Sink<'_>) -> bool {
    let mut words = Words { bytes: list.as_bytes(), text: list, at: 0 };
    let mut begun = false;
    while words.peek().is_some() {
        let Some(corner) = words.pair() else { break };
        sink(if begun { PathEl::LineTo(corner) } else { PathEl::MoveTo(corner) });
        begun = true;
    }
    if begun && closed {
        sink(PathEl::ClosePath);
    }
    words.peek().is_none()
}

/// Sends an arc of an ellipse to `sink`: from the angle `from`, `turn` further, in curves of an eighth of a turn or
/// less, which are off by 4e-6 of the radius. Their number hangs on the angle alone.
pub fn arc(centre: Point, radii: Vec2, tilt: f64, from: f64, turn: f64, sink: Sink<'_>) {
    let count = (turn.abs() / std::f64::consts::FRAC_PI_4 - 1e-9).ceil().clamp(1.0, 8.0);
    let step = turn / count;
    let arm = 4.0 / 3.0 * (0.25 * step).tan();
    let axes =
        (Vec2::from_angle(tilt) * radii.x, Vec2::from_angle(tilt + std::f64::consts::FRAC_PI_2) * radii.y);
    let place = |p: Vec2| centre + axes.0 * p.x + axes.1 * p.y;
    let ahead = |p: Vec2| Vec2::new(-p.y, p.x) * arm;
    let mut start = Vec2::from_angle(from);
    for k in 1..=count as usize {
        let end = Vec2::from_angle(from + step * k as f64);
        sink(PathEl::CurveTo(place(start + ahead(start)), place(end - ahead(end)), place(end)));
        start = end;
    }
}

struct Pen<'a> {
    sink: Sink<'a>,
    at: Point,
    start: Point,
    /// The last control point, and whether it was one of a cubic curve.
    control: Option<(Point, bool)>,
    /// Where the next line begins after a path was closed.
    moved: Option<Point>,
    begun: bool,
}

impl Pen<'_> {
    /// Draws one command whose letter was read; None where it is miswritten.
    fn command(&mut self, letter: u8, words: &mut Words<'_>) -> Option<()> {
        let upper = letter.to_ascii_uppercase();
        if upper != b'M' && !self.begun {
            return None;
        }
        let base = if letter.is_ascii_lowercase() { self.at.to_vec2() } else { Vec2::ZERO };
        let mut place = || words.pair().map(|pair| pair + base);
        let mirrored = |cubic: bool| match self.control {
            Some((control, kind)) if kind == cubic => self.at + (self.at - control),
            _ => self.at,
        };
        match upper {
            b'M' => {
                let to = place()?;
                (self.at, self.start, self.control, self.moved, self.begun) = (to, to, None, None, true);
                (self.sink)(PathEl::MoveTo(to));
            }
            b'L' => {
                let to = place()?;
                self.draw(PathEl::LineTo(to), to, None);
            }
            b'H' => {
                let to = Point::new(words.number()? + base.x, self.at.y);
                self.draw(PathEl::LineTo(to), to, None);
            }
            b'V' => {
                let to = Point::new(self.at.x, words.number()? + base.y);
                self.draw(PathEl::LineTo(to), to, None);
            }
            b'Q' | b'T' => {
                let control = if upper == b'Q' { place()? } else { mirrored(false) };
                let to = place()?;
                self.draw(PathEl::QuadTo(control, to), to, Some((control, false)));
            }
            b'C' | b'S' => {
                let first = if upper == b'C' { place()? } else { mirrored(true) };
                let (second, to) = (place()?, place()?);
                self.draw(PathEl::CurveTo(first, second, to), to, Some((second, true)));
            }
            b'A' => {
                let radii = words.pair()?.to_vec2();
                let tilt = words.number()?.to_radians();
                let (large, sweep) = (words.flag()?, words.flag()?);
                let to = words.pair()? + base;
                self.arc(radii, tilt, large, sweep, to);
            }
            b'Z' => {
                (self.sink)(PathEl::ClosePath);
                (self.at, self.control, self.moved) = (self.start, None, Some(self.start));
            }
            _ => return None,
        }
        Some(())
    }

    fn draw(&mut self, element: PathEl, to: Point, control: Option<(Point, bool)>) {
        if let Some(from) = self.moved.take() {
            (self.sink)(PathEl::MoveTo(from));
        }
        (self.sink)(element);
        (self.at, self.control) = (to, control);
    }

    /// An arc by its ends, as SVG 1.1 has it (appendix F.6), in the plane where the ellipse is the unit circle.
    fn arc(&mut self, radii: Vec2, tilt: f64, large: bool, sweep: bool, to: Point) {
        let radii = Vec2::new(radii.x.abs(), radii.y.abs());
        let (half, axis) = ((self.at - to) * 0.5, Vec2::from_angle(tilt));
        let half = Vec2::new(axis.dot(half) / radii.x, axis.cross(half) / radii.y);
        let long = half.hypot();
        // As good as a straight line, also where there is no ellipse; of a circle far away rounding leaves nothing.
        let flat = long * (radii.x / radii.y).max(radii.y / radii.x) < 1e-7 && !large;
        if flat || !long.is_normal() || radii.x == 0.0 || radii.y == 0.0 {
            return self.draw(PathEl::LineTo(to), to, None);
        }
        // Ellipses that are too small grow until they reach.
        let grown = long.max(1.0);
        let (half, side) = (half / grown, (1.0 - (long / grown).powi(2)).max(0.0).sqrt());
        let side = if large == sweep { side } else { -side };
        let centre = Vec2::new(half.y, -half.x) * (side / half.hypot());
        let (from, till) = ((half - centre).atan2(), (-half - centre).atan2());
        let turn = (till - from).rem_euclid(std::f64::consts::TAU);
        let turn = if sweep { turn } else { turn - std::f64::consts::TAU };
        let radii = radii * grown;
        let away = axis * (centre.x * radii.x) + Vec2::new(-axis.y, axis.x) * (centre.y * radii.y);
        let middle = self.at.midpoint(to) + away;
        if let Some(from) = self.moved.take() {
            (self.sink)(PathEl::MoveTo(from));
        }
        // It ends where the path says, and not where rounding has led it.
        let mut last = None;
        arc(middle, radii, tilt, from, turn, &mut |element| {
            if let Some(before) = last.replace(element) {
                (self.sink)(before);
            }
        });
        if let Some(PathEl::CurveTo(first, second, _)) = last {
            (self.sink)(PathEl::CurveTo(first, second, to));
        }
        (self.at, self.control) = (to, None);
    }
}

struct Words<'a> {
    bytes: &'a [u8],
    text: &'a str,
    at: usize,
}

impl Words<'_> {
    fn next(&self) -> Option<u8> {
        self.bytes.get(self.at).copied()
    }

    /// What comes after blanks.
    fn peek(&mut self) -> Option<u8> {
        while matches!(self.next(), Some(b' ' | b'\t' | b'\n' | b'\r' | 12)) {
            self.at += 1;
        }
        self.next()
    }

    fn skip_comma(&mut self) {
        if self.peek() == Some(b',') {
            self.at += 1;
        }
    }

    fn digits(&mut self) -> usize {
        let from = self.at;
        while self.next().is_some_and(|byte| byte.is_ascii_digit()) {
            self.at += 1;
        }
        self.at - from
    }

    fn number(&mut self) -> Option<f64> {
        self.peek();
        let from = self.at;
        self.at += usize::from(matches!(self.next(), Some(b'+' | b'-')));
        let mut count = self.digits();
        if self.next() == Some(b'.') {
            self.at += 1;
            count += self.digits();
        }
        if count == 0 {
            self.at = from;
            return None;
        }
        if matches!(self.next(), Some(b'e' | b'E')) {
            let end = self.at;
            self.at += 1;
            self.at += usize::from(matches!(self.next(), Some(b'+' | b'-')));
            if self.digits() == 0 {
                self.at = end;
            }
        }
        let number = self.text[from..self.at].parse().ok();
        self.skip_comma();
        number
    }

    fn pair(&mut self) -> Option<Point> {
        Some(Point::new(self.number()?, self.number()?))
    }

    /// 0 or 1, which may stand close to what follows.
    fn flag(&mut self) -> Option<bool> {
        let flag = match self.peek()? {
            b'0' => false,
            b'1' => true,
            _ => return None,
        };
        self.at += 1;
        self.skip_comma();
        Some(flag)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn all(data: &str) -> (Vec<PathEl>, bool) {
        let mut found = Vec::new();
        let whole = path(data, &mut |element| found.push(element));
        (found, whole)
    }

    /// The end of each element.
    fn ends(data: &str) -> Vec<[f64; 2]> {
        let end = |element: &PathEl| element.end_point().map(|p| [p.x, p.y]);
        all(data).0.iter().filter_map(end).collect()
    }

    #[test]
    fn commands_are_absolute_or_relative_and_may_be_left_out() {
        let square = vec![[1.0, 2.0], [4.0, 2.0], [4.0, 7.0], [1.0, 7.0]];
        for data in [
            "M1 2L4 2 4 7 1 7",
            "m1,2l3,0,0,5-3,0",
            "M1 2H4V7H1",
            "m1 2h3v5h-3",
            "M1e0 2h+3v.5e1h-3.",
            "M1 2 4 2 4 7 1 7",
        ] {
            assert_eq!(ends(data), square, "{data}");
            assert!(all(data).1, "{data}");
        }
        assert_eq!(ends("M1 1h1z l2 2"), [[1.0, 1.0], [2.0, 1.0], [1.0, 1.0], [3.0, 3.0]]);
    }

    #[test]
    fn smooth_curves_mirror_the_last_control_point_of_their_own_kind() {
        let p = Point::new;
        let second = |data: &str| all(data).0[2];
        assert_eq!(
            second("M0 0C0 1 1 2 2 2S4 4 5 5"),
            PathEl::CurveTo(p(3.0, 2.0), p(4.0, 4.0), p(5.0, 5.0))
        );
        assert_eq!(second("M0 0Q0 1 1 1S4 4 5 5"), PathEl::CurveTo(p(1.0, 1.0), p(4.0, 4.0), p(5.0, 5.0)));
        assert_eq!(second("M0 0Q0 1 1 1t1 0"), PathEl::QuadTo(p(2.0, 1.0), p(2.0, 1.0)));
        assert_eq!(second("M0 0L0 1t1 0"), PathEl::QuadTo(p(0.0, 1.0), p(1.0, 1.0)));
    }

    #[test]
    fn arcs_lie_on_their_ellipse_and_end_where_they_should() {
        for (flags, centre) in
            [("0 1", [0.0, 0.0]), ("1 0", [0.0, 0.0]), ("0 0", [5.0, 5.0]), ("1 1", [5.0, 5.0])]
        {
            let data = format!("M0 5A5 5 0 {flags} 5 0");
            for [x, y] in ends(&data) {
                let off = (x - centre[0]).hypot(y - centre[1]) - 5.0;
                assert!(off.abs() < 1e-12, "{data}: {x} {y}");
            }
            assert_eq!(ends(&data).last(), Some(&[5.0, 0.0]));
        }
        // Too small a circle grows; none at all is a straight line.
        assert!(
            ends("M0 0A1 1 0 0 1 8 0")
                .iter()
                .any(|&[x, y]| (x - 4.0).abs() < 1e-12 && (y + 4.0).abs() < 1e-12)
        );
        for data in [
            "M0 0A0 5 0 0 1 8 0",
            "M0 0A1e300 1e300 0 0 1 8 0",
            "M0 0a5 5 0 1100",
            "M0 0A1e-320 1e300 0 0 1 8 0",
        ] {
            assert!(ends(data).len() <= 2, "{data}");
        }
        assert!(all("M0 0a25,25-30 0150-25").1);
    }

    #[test]
    fn the_number_of_curves_hangs_on_nothing_but_the_angle() {
        for r in ["1e-300", "5e-324", "1e-9", "3", "5e82", "1e300", "1e999", "-4"] {
            for flags in ["00", "01", "10", "11"] {
                let (found, whole) = all(&format!("M0 0a{r} 2 3 {flags}2 1a2 {r} 3 {flags}2 1z"));
                assert!(whole && found.len() <= 18, "{r}: {}", found.len());
            }
        }
    }

    #[test]
    fn what_follows_a_mistake_is_not_drawn() {
        for (data, count) in
            [("M0 0L1 1L2", 2), ("M0 0h1x", 2), ("hello", 0), ("M", 0), ("1 2", 0), ("M0 0;", 1), ("Mé", 0)]
        {
            let (found, whole) = all(data);
            assert!(!whole && found.len() == count, "{data}: {found:?}");
        }
        assert!(all("").1);
        assert!(all(" M 0 0 h 1 , v 1 z ").1);
    }
}
