//! Complete pictures of graph-directed shapes.

use frond_core::{Affine2, Colouring, DirectedIfs, Hull};
use glam::DVec2;

use crate::coverage::canvas::Canvas;
use crate::coverage::sweep::Progress;
use crate::picture::bitmap::Bitmap;
use crate::picture::colour::Colours;
use crate::picture::resolve::picture_of_codes;
use crate::picture::view::View;
use crate::picture::window::Window;
use crate::pieces::frame::{TIPS, enclosing_ellipse, steps};
use crate::pieces::letters::Letters;
use crate::raster::{CERTAIN_REACH, MAX_SIDE, RenderError};

/// What the colours of a graph-directed shape tell.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum DirectedColours {
    /// Which map of the shape a point lies in.
    #[default]
    Map,
    /// Which state is copied there, after so many maps: 1 to 8.
    State(u8),
}

/// What [`rasterize_directed`] draws.
#[derive(Clone, Copy, Debug)]
pub struct DirectedOptions<'a> {
    /// Pixels a row, at most [`MAX_SIDE`].
    pub width: u32,
    /// Rows, at most [`MAX_SIDE`].
    pub height: u32,
    /// Which state is drawn, from 0.
    pub state: usize,
    /// What part of the plane. Default: all of the state, with a margin of a twentieth.
    pub view: Option<View>,
    /// What the colours tell.
    pub colours: DirectedColours,
    /// One sRGB colour a map or a state, repeated when there are more; empty for Okabe and Ito's.
    pub palette: &'a [[u8; 3]],
    /// Whether edges are smoothed. Either way the same pixels are lit.
    pub smooth: bool,
}

/// A state in coordinates of its own: it lies in the unit disc.
struct State {
    /// The maps into these coordinates from those of the states that are copied, and these.
    maps: Vec<(Affine2, usize)>,
    to_world: Affine2,
    /// Points of the state, in these coordinates: one near the middle of those known, then some that stick out.
    tips: Vec<DVec2>,
}

/// A copy of a state on the screen.
#[derive(Clone, Copy)]
struct Node {
    map: Affine2,
    state: usize,
    /// How many maps led here, up to what the colours ask for.
    steps: u8,
    letters: Letters,
}

/// Draws a state of a graph-directed system: RGBA with straight alpha, row 0 on top, on a transparent background.
///
/// It keeps what [`rasterize`](crate::rasterize) promises: every pixel that the shape reaches into by a sixteenth
/// of a pixel or more is lit, and none without a point of it. Where copies cover each other so often that not all
/// can be visited, large copies are drawn as clouds of points that are as dense as the pixels. A state that is not
/// there gives an empty picture.
///
/// # Errors
/// [`RenderError::TooLarge`] and [`RenderError::View`].
pub fn rasterize_directed(
    system: &DirectedIfs,
    options: &DirectedOptions<'_>,
) -> Result<Vec<u8>, RenderError> {
    let &DirectedOptions { width, height, state, .. } = options;
    if width > MAX_SIDE || height > MAX_SIDE {
        return Err(RenderError::TooLarge { width, height });
    }
    if options.view.is_some_and(|view| !view.is_valid()) {
        return Err(RenderError::View);
    }
    let window = Window { width, height };
    if window.area() == 0 || state >= system.len() {
        return Ok(vec![0; 4 * window.area()]);
    }
    let hulls = Hull::of_states(system);
    let view = options.view.unwrap_or_else(|| View::fit(&hulls[state], width, height, 0.05));
    let factor = if options.smooth { 2 } else { 1 };
    let fine = Window { width: width * factor, height: height * factor };
    let (codes, _) = directed_codes(system, &hulls, options, view, fine);
    let letters = match options.colours {
        DirectedColours::Map => system.states()[state].len(),
        DirectedColours::State(_) => system.len(),
    };
    let mut colours = Colours::new(Colouring::Map, options.palette, letters);
    colours.source = [fine.width as i32, fine.height as i32];
    colours.factor = factor as f32;
    Ok(picture_of_codes(&colours, &codes, window))
}

/// Visits before overlap is suspected, at least, and for each lit pixel: as of a shape of one state.
const PATIENCE: u64 = 200_000;
const VISITS_A_PIXEL: u64 = 300;
/// Where the window shows a small part only, it takes a while to find anything in it.
const CLOSE_PATIENCE: u64 = 2_000_000;
/// Levels of maps that colours may ask for.
const MOST_LEVELS: u8 = 8;

/// The codes of the pixels of a window, and whether they are known to be all.
fn directed_codes(
    system: &DirectedIfs,
    hulls: &[Hull],
    options: &DirectedOptions<'_>,
    view: View,
    fine: Window,
) -> (Vec<u32>, Progress) {
    let states = states(system, hulls);
    let level = match options.colours {
        DirectedColours::Map => 1,
        DirectedColours::State(level) => level.clamp(1, MOST_LEVELS),
    };
    let scale = f64::from(fine.width) / f64::from(options.width.max(1));
    let window = Window { width: options.width, height: options.height };
    let root = Node {
        map: view.onto_target(states[options.state].to_world, window, scale),
        state: options.state,
        steps: 0,
        letters: Letters::NONE,
    };
    let mut codes = vec![0; fine.area()];
    let mut canvas = Canvas { lit: Bitmap::new(fine), count: 0 };
    let mut stack = vec![root];
    if !root.map.is_finite() {
        return (codes, Progress::Complete);
    }
    let mut light = |hit: crate::coverage::canvas::Hit| {
        let (x, y) = hit.pixel;
        codes[y as usize * fine.width as usize + x as usize] = hit.letters.code();
    };
    let close = fine
        .extent(&root.map)
        .is_some_and(|extent| extent.size > 2.0 * f64::from(fine.width.max(fine.height)));
    let patience = if close { CLOSE_PATIENCE } else { PATIENCE };
    let mut visited = 0_u64;
    let colours = Letter { by_state: matches!(options.colours, DirectedColours::State(_)), level };
    while let Some(node) = stack.pop() {
        visited += 1;
        let Some(extent) = fine.extent(&node.map) else { continue };
        if canvas.lit.all(extent.pixels) {
            continue;
        }
        let small = extent.size <= CERTAIN_REACH * scale || extent.one_pixel();
        if small && (node.letters.count() > 0 || node.steps > 0) {
            let letters = colours.of_small(&node);
            for (k, tip) in states[node.state].tips.iter().enumerate() {
                if k == 0 || !extent.one_pixel() {
                    canvas.light(node.map.apply(*tip), letters, &mut light);
                }
            }
            continue;
        }
        parts(&states, &node, colours, &mut stack);
        if visited > patience + VISITS_A_PIXEL * canvas.count {
            fill(&states, root, colours, &mut canvas, &mut light);
            return (codes, Progress::Probed);
        }
    }
    (codes, Progress::Complete)
}

/// Which letter a copy gets, and after how many maps.
#[derive(Clone, Copy)]
struct Letter {
    by_state: bool,
    level: u8,
}

impl Letter {
    /// The letters of a copy that is smaller than a pixel, which may have come before its level.
    fn of_small(self, node: &Node) -> Letters {
        if node.letters.count() > 0 { node.letters } else { Letters::NONE.then(node.state) }
    }
}

/// Puts the parts of a copy on the stack, the last on top.
fn parts(states: &[State], node: &Node, colours: Letter, stack: &mut Vec<Node>) {
    for (k, (map, from)) in states[node.state].maps.iter().enumerate() {
        let steps = node.steps.saturating_add(1);
        let letters = match (node.letters.count(), colours.by_state) {
            (0, false) => Letters::NONE.then(k),
            (0, true) if steps >= colours.level => Letters::NONE.then(*from),
            _ => node.letters,
        };
        stack.push(Node { map: node.map * *map, state: *from, steps, letters });
    }
}

fn states(system: &DirectedIfs, hulls: &[Hull]) -> Vec<State> {
    let to_world: Vec<Affine2> = hulls.iter().map(|hull| enclosing_ellipse(hull.vertices())).collect();
    let maps: Vec<Vec<(Affine2, usize)>> = system
        .states()
        .iter()
        .zip(&to_world)
        .map(|(maps, own)| {
            // The ellipse is never singular.
            let inverse = own.linear.inverse();
            let seen = |map: &Affine2, inner: &Affine2| {
                let moved = map.apply(inner.translation) - own.translation;
                Affine2::new(inverse * map.linear * inner.linear, inverse * moved)
            };
            maps.iter().map(|part| (seen(&part.map, &to_world[part.from]), part.from)).collect()
        })
        .collect();
    let tips = tips(system, &maps, &to_world);
    let state = |((maps, to_world), tips)| State { maps, to_world, tips };
    maps.into_iter().zip(to_world).zip(tips).map(state).collect()
}

/// Rounds in which points that stick out are sought.
const TIP_ROUNDS: usize = 12;

/// Of each state a point, then those that are farthest in some direction of what a few steps lead to.
fn tips(system: &DirectedIfs, maps: &[Vec<(Affine2, usize)>], to_world: &[Affine2]) -> Vec<Vec<DVec2>> {
    let anchor =
        |(point, to_world): (DVec2, &Affine2)| to_world.linear.inverse() * (point - to_world.translation);
    let anchors: Vec<DVec2> = system.points().into_iter().zip(to_world).map(anchor).collect();
    let mut tips: Vec<Vec<DVec2>> = anchors.iter().map(|&point| vec![point]).collect();
    let far = |points: &[DVec2], direction: DVec2| {
        points.iter().copied().max_by(|p, q| p.dot(direction).total_cmp(&q.dot(direction)))
    };
    for _ in 0..TIP_ROUNDS {
        let next = maps.iter().zip(&tips).map(|(maps, own)| {
            let mut found: Vec<DVec2> = Vec::with_capacity(TIPS);
            for k in 0..TIPS {
                let direction = DVec2::from_angle(std::f64::consts::TAU * k as f64 / TIPS as f64);
                let images = maps.iter().filter_map(|(map, from)| {
                    let pulled = map.linear.transpose() * direction;
                    far(&tips[*from], pulled).map(|point| map.apply(point))
                });
                let all: Vec<DVec2> =
                    images.chain(own.iter().copied()).filter(|p| p.length_squared() <= 1.0 + 1e-6).collect();
                // One tip serves several directions.
                found.extend(
                    far(&all, direction).filter(|p| found.iter().all(|q| q.distance_squared(*p) > 1e-6)),
                );
            }
            if found.is_empty() { own.clone() } else { found }
        });
        tips = next.collect();
    }
    for (own, anchor) in tips.iter_mut().zip(anchors) {
        own.insert(0, anchor);
    }
    tips
}

/// The finest grid of a cloud, and points that are taken through all maps for all of them.
const FINEST_GRID: f64 = 2048.0;
const MOST_CLOUD_STEPS: f64 = 1.2e7;
/// The largest copies that are drawn as clouds, in pixels, and how many at most.
const LARGEST_COPY: f64 = 512.0;
const MOST_COPIES: usize = 20_000;
/// Points that are drawn, for each pixel of the window and on top.
const MOST_WORK: (u64, u64) = (64, 16_000_000);

/// Ways back to a state, of one map or two, whose powers are steps.
const MOST_ROUNDS: usize = 64;

/// Draws large copies as clouds of points, which no overlap can slow down.
fn fill(
    states: &[State],
    root: Node,
    colours: Letter,
    canvas: &mut Canvas,
    light: &mut impl FnMut(crate::coverage::canvas::Hit),
) {
    let window = canvas.lit.window();
    // Copies that are lettered, no larger than the finest grid resolves, and reach into dark pixels.
    let mut waiting = Vec::new();
    let mut stack = vec![root];
    let mut looked = 0_usize;
    while let Some(node) = stack.pop() {
        looked += 1;
        if waiting.len() >= MOST_COPIES || looked > 50 * MOST_COPIES {
            break;
        }
        let Some(extent) = window.extent(&node.map) else { continue };
        if canvas.lit.all(extent.pixels) {
            continue;
        }
        let whole = extent.size <= FINEST_GRID;
        if node.letters.count() > 0
            && (extent.size <= LARGEST_COPY || (whole && waiting.len() < MOST_COPIES / 10))
        {
            waiting.push((node, extent.size));
        } else {
            parts(states, &node, colours, &mut stack);
        }
    }
    let largest = waiting.iter().map(|(_, size)| *size).fold(16.0, f64::max);
    let arrows: usize = states.iter().map(|state| state.maps.len()).sum();
    let finest = FINEST_GRID.min((MOST_CLOUD_STEPS / arrows as f64).sqrt());
    let clouds = clouds(states, (2.0 * largest).clamp(16.0, finest) as u32);
    let mut left = MOST_WORK.0 * window.area() as u64 + MOST_WORK.1;
    // What was found first lies on top.
    for (node, _) in waiting {
        let Some(extent) = window.extent(&node.map) else { continue };
        if canvas.lit.all(extent.pixels) {
            continue;
        }
        let letters = colours.of_small(&node);
        for [x, y] in &clouds[node.state] {
            canvas.light(node.map.apply(DVec2::new(f64::from(*x), f64::from(*y))), letters, light);
        }
        left = left.saturating_sub(clouds[node.state].len() as u64);
        if left == 0 {
            return;
        }
    }
}

/// Points of every state on a grid of `size` x `size` cells over its disc: each point that is found is taken
/// through all maps, and images in cells that hold none yet are kept.
fn clouds(states: &[State], size: u32) -> Vec<Vec<[f32; 2]>> {
    // Of each state where its copies go: into which state, and by which map.
    let mut out: Vec<Vec<(usize, Affine2)>> = vec![Vec::new(); states.len()];
    for (into, state) in states.iter().enumerate() {
        for (map, from) in &state.maps {
            out[*from].push((into, *map));
        }
    }
    // Ways back to a state that shrink little would take for ever: their powers are steps as well.
    for (state, own) in states.iter().enumerate() {
        let rounds = own.maps.iter().flat_map(|(map, from)| {
            let direct = (*from == state).then_some(*map);
            let back = states[*from].maps.iter().filter(move |(_, to)| *from != state && *to == state);
            direct.into_iter().chain(back.map(|(next, _)| *map * *next))
        });
        let rounds: Vec<Affine2> = rounds.take(MOST_ROUNDS).collect();
        out[state].extend(steps(&rounds).into_iter().skip(rounds.len()).map(|(map, _)| (state, map)));
    }
    let window = Window { width: size, height: size };
    let mut cells: Vec<Bitmap> = states.iter().map(|_| Bitmap::new(window)).collect();
    let mut clouds: Vec<Vec<[f32; 2]>> = vec![Vec::new(); states.len()];
    let mut open: Vec<(usize, DVec2)> = Vec::new();
    let half = 0.5 * f64::from(size);
    let mut keep = |state: usize, point: DVec2, open: &mut Vec<(usize, DVec2)>| {
        let Some(cell) = window.pixel((point + DVec2::ONE) * half) else { return };
        if cells[state].set(cell) {
            clouds[state].push([point.x as f32, point.y as f32]);
            open.push((state, point));
        }
    };
    for (state, own) in states.iter().enumerate() {
        own.tips.iter().for_each(|tip| keep(state, *tip, &mut open));
    }
    while let Some((state, point)) = open.pop() {
        for (into, map) in &out[state] {
            keep(*into, map.apply(point), &mut open);
        }
    }
    clouds
}

#[cfg(test)]
mod tests {
    use frond_core::{DirectedMap, Ifs};

    use super::*;
    use crate::raster::{RasterOptions, rasterize};
    use crate::testing::{NASTY, PLAIN, ifs};

    const OPTIONS: DirectedOptions<'static> = DirectedOptions {
        width: 120,
        height: 90,
        state: 0,
        view: None,
        colours: DirectedColours::Map,
        palette: &[],
        smooth: false,
    };

    fn drawn(system: &DirectedIfs, options: &DirectedOptions<'_>) -> Vec<u8> {
        rasterize_directed(system, options).unwrap()
    }

    fn lit(picture: &[u8]) -> usize {
        picture.chunks_exact(4).filter(|pixel| pixel[3] > 0).count()
    }

    /// Two states that copy each other, each of which is the shape of one system.
    fn twice(ifs: &Ifs) -> DirectedIfs {
        let state = |from| ifs.maps().iter().map(|&map| DirectedMap { from, map }).collect();
        DirectedIfs::new(vec![state(1), state(0)]).unwrap()
    }

    #[test]
    fn a_shape_is_drawn_as_that_of_one_system_is() {
        let plain = RasterOptions { width: 120, height: 90, smooth: false, ..RasterOptions::default() };
        for name in PLAIN {
            let ifs = ifs(name);
            let view = View::fit(&Hull::of(&ifs), 120, 90, 0.05);
            let told = rasterize(&ifs, &RasterOptions { view: Some(view), ..plain }).unwrap();
            for system in [DirectedIfs::from(&ifs), twice(&ifs)] {
                let own = drawn(&system, &DirectedOptions { view: Some(view), ..OPTIONS });
                let alike = |(a, b): &(&[u8], &[u8])| (a[3] > 0) == (b[3] > 0);
                let pixels = || told.chunks_exact(4).zip(own.chunks_exact(4));
                let differ = pixels().filter(|pair| !alike(pair)).count();
                assert!(differ as f64 <= 0.01 * lit(&told) as f64, "{name}: {differ} of {}", lit(&told));
                let colours = pixels().filter(|(a, b)| a[3] > 0 && b[3] > 0 && a != b).count();
                assert!(colours as f64 <= 0.01 * lit(&told) as f64, "{name}: {colours}");
            }
        }
    }

    #[test]
    fn shapes_that_overlap_without_end_are_drawn_all_the_same() {
        for name in NASTY {
            let ifs = ifs(name);
            let view = Some(View::fit(&Hull::of(&ifs), 120, 90, 0.05));
            let plain = RasterOptions { width: 120, height: 90, view, ..RasterOptions::default() };
            let told = rasterize(&ifs, &plain).unwrap();
            let own = drawn(&twice(&ifs), &DirectedOptions { smooth: true, view, ..OPTIONS });
            let (told, own) = (lit(&told) as f64, lit(&own) as f64);
            assert!((own / told - 1.0).abs() < 0.03, "{name}: {own} {told}");
        }
    }

    #[test]
    fn states_have_colours_by_level() {
        // A square of two kinds, in a board: at the second level each kind is half.
        let half =
            |from, x: f64, y: f64| DirectedMap { from, map: Affine2::from_row([0.5, 0.0, 0.0, 0.5, x, y]) };
        let board = |a: usize| {
            vec![half(a, 0.0, 0.0), half(1 - a, 0.5, 0.0), half(1 - a, 0.0, 0.5), half(a, 0.5, 0.5)]
        };
        let system = DirectedIfs::new(vec![board(0), board(1)]).unwrap();
        let palette = [[255, 0, 0], [0, 0, 255]];
        for level in [1, 2, 3] {
            let options = DirectedOptions {
                width: 64,
                height: 64,
                colours: DirectedColours::State(level),
                palette: &palette,
                view: Some(View { x: 0.5, y: 0.5, scale: 64.0 }),
                ..OPTIONS
            };
            let picture = drawn(&system, &options);
            assert_eq!(lit(&picture), 64 * 64);
            let red = |x: usize, y: usize| picture[4 * (64 * y + x)] == 255;
            // The lower left cell is of the state itself, and the one beside it is not.
            let cell = 64 >> level;
            assert!(red(cell / 2, 63 - cell / 2) && !red(cell + cell / 2, 63 - cell / 2), "{level}");
        }
    }

    #[test]
    fn what_is_not_there_is_empty_and_what_is_too_large_is_refused() {
        let system = twice(&ifs("gasket"));
        assert_eq!(lit(&drawn(&system, &DirectedOptions { state: 2, ..OPTIONS })), 0);
        assert!(drawn(&system, &DirectedOptions { width: 0, ..OPTIONS }).is_empty());
        let code = |options: DirectedOptions<'_>| rasterize_directed(&system, &options).unwrap_err().code();
        assert_eq!(code(DirectedOptions { width: 8193, ..OPTIONS }), "picture-too-large");
        let view = Some(View { x: 0.0, y: f64::NAN, scale: 1.0 });
        assert_eq!(code(DirectedOptions { view, ..OPTIONS }), "view");
        // Far away there is nothing, and close by there is as much as there is of the plain one.
        let away = Some(View { x: 1e9, y: 0.0, scale: 1.0 });
        assert_eq!(lit(&drawn(&system, &DirectedOptions { view: away, ..OPTIONS })), 0);
    }
}
