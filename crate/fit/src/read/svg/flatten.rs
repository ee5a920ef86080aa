//! Shapes as lines: their curves in as many straight sides as can be told apart.

use glam::DVec2;
use kurbo::{PathEl, Point, Rect};

use super::super::gather::{About, Gathered, Line};
use super::super::problem::ReadError;
use super::paths::{FLATNESS, elements};
use super::visible::{Drawn, Shape};
use crate::outline::bounds;

/// Points of all lines once their curves are flattened.
const MAX_POINTS: usize = 1 << 23;

/// The largest parts, each known by its shape and its place in it, and how many parts each shape has.
pub type Parts = (Gathered<(usize, usize)>, Vec<usize>);

/// The parts of all shapes as lines with y up.
pub fn flatten(shapes: &[Shape<'_>], around: Option<Rect>, page: Rect) -> Result<Parts, ReadError> {
    let size = around.map_or(0.0, |around| around.size().to_vec2().hypot());
    let mut pencil = Pencil {
        tolerance: (FLATNESS * size).max(1e-12),
        page: None,
        gathered: Gathered::default(),
        parts: Vec::new(),
        line: Line::default(),
        closed: false,
        at: Point::ORIGIN,
        count: 0,
    };
    for shape in shapes {
        pencil.parts.push(0);
        pencil.page = shape.simple.then_some(page);
        match &shape.drawn {
            Drawn::Path(path, place) => elements(path).for_each(|element| pencil.draw(*place * element)),
            Drawn::Cut(region) => {
                for line in region {
                    line.iter().for_each(|&[x, y]| pencil.push(Point::new(x, y)));
                    pencil.closed = true;
                    pencil.lift();
                }
            }
        }
        pencil.lift();
        if pencil.count >= MAX_POINTS {
            return Err(ReadError::TooMany { what: "points", most: MAX_POINTS });
        }
    }
    Ok((pencil.gathered, pencil.parts))
}

struct Pencil {
    tolerance: f64,
    /// What a ground would have to cover.
    page: Option<Rect>,
    gathered: Gathered<(usize, usize)>,
    parts: Vec<usize>,
    line: Line,
    closed: bool,
    at: Point,
    count: usize,
}

impl Pencil {
    fn draw(&mut self, element: PathEl) {
        if self.count >= MAX_POINTS {
            return;
        }
        match element {
            PathEl::MoveTo(p) => {
                self.lift();
                self.push(p);
            }
            PathEl::LineTo(p) => self.push(p),
            PathEl::QuadTo(..) | PathEl::CurveTo(..) => {
                kurbo::flatten([PathEl::MoveTo(self.at), element], self.tolerance, |element| {
                    if let PathEl::LineTo(p) = element {
                        self.push(p);
                    }
                });
            }
            PathEl::ClosePath => self.closed = true,
        }
    }

    fn push(&mut self, p: Point) {
        self.count += 1;
        self.at = p;
        self.line.push(DVec2::new(p.x, -p.y));
    }

    /// Ends a line.
    fn lift(&mut self) {
        let shape = self.parts.len() - 1;
        if self.line.count > 1 {
            let label = (shape, self.parts[shape]);
            self.parts[shape] += 1;
            let closed = self.closed || self.line.returns();
            let ground = self.page.is_some_and(|page| covers(self.line.points(), page));
            self.gathered.take(&self.line, About { label, closed, ground });
        }
        self.line.clear();
        self.closed = false;
    }
}

/// Whether a line goes round as good as all of the page, as grounds do.
fn covers(line: &[DVec2], page: Rect) -> bool {
    let (low, high) = bounds(line);
    let slack = 0.01 * page.width().max(page.height());
    let bounds = Rect::new(low.x, -high.y, high.x, -low.y).inflate(slack, slack);
    bounds.union(page) == bounds
}
