// Clouds of points placed on the screen by pieces. CPU twin: src/points.rs.

struct Screen {
    // Width and height of the target, in pixels.
    size: vec2<f32>,
    // What masses are multiplied by.
    mass: f32,
    // 1 where pieces have colours of their own.
    tinted: f32,
    // Row by row: from the unit disc to the two sides along which pieces are twisted.
    sides: vec4<f32>,
}

@group(0) @binding(0) var<uniform> screen: Screen;

struct Point {
    // Within the unit disc.
    @location(0) position: vec2<f32>,
    // The first letters of its address: three times six bits.
    @location(1) letters: u32,
    @location(2) mass: f32,
}

struct Piece {
    // Row by row.
    @location(3) linear: vec4<f32>,
    @location(4) translation: vec2<f32>,
    // As above, and their count from bit 18 on.
    @location(5) letters: u32,
    @location(6) mass: f32,
    // What is added, times how far along the one side and along the other.
    @location(7) twist: vec2<f32>,
    // A colour, eight bits each.
    @location(8) tint: u32,
}

// One more than the largest code.
const CODES: f32 = 262145.0;

// The middle of the pixel that a point falls on, so that no rule of rasterising and no rounding of it
// moves the point to another one.
fn place(point: Point, piece: Piece, depth: f32) -> vec4<f32> {
    let along = screen.sides.x * point.position.x + screen.sides.y * point.position.y;
    let up = screen.sides.z * point.position.x + screen.sides.w * point.position.y;
    let x = piece.linear.x * point.position.x + piece.linear.y * point.position.y + piece.translation.x;
    let y = piece.linear.z * point.position.x + piece.linear.w * point.position.y + piece.translation.y;
    let pixel = floor(vec2<f32>(x, y) + piece.twist * (along * up));
    if !(pixel.x >= 0.0 && pixel.y >= 0.0 && pixel.x < screen.size.x && pixel.y < screen.size.y) {
        // Outside of what is clipped.
        return vec4<f32>(2.0, 2.0, 0.0, 1.0);
    }
    let part = (pixel + 0.5) / screen.size;
    return vec4<f32>(part.x * 2.0 - 1.0, 1.0 - part.y * 2.0, depth, 1.0);
}

// The letters of the piece, then those of the point.
fn code_of(point: Point, piece: Piece) -> u32 {
    let count = piece.letters >> 18u;
    return ((piece.letters & 0x3ffffu) | (point.letters >> (6u * count))) + 1u;
}

struct Coded {
    @builtin(position) position: vec4<f32>,
    @location(0) @interpolate(flat, either) code: u32,
}

@vertex
fn codes_vertex(point: Point, piece: Piece) -> Coded {
    let code = code_of(point, piece);
    // Later maps lie on top, whatever the colour.
    return Coded(place(point, piece, f32(code) / CODES), select(code, piece.tint + 1u, screen.tinted > 0.5));
}

@fragment
fn codes_fragment(in: Coded) -> @location(0) u32 {
    return in.code;
}

struct Weighed {
    @builtin(position) position: vec4<f32>,
    @location(0) @interpolate(flat, either) sum: vec4<f32>,
}

@vertex
fn density_vertex(point: Point, piece: Piece) -> Weighed {
    let weight = point.mass * piece.mass * screen.mass;
    let colour = colour_of(code_of(point, piece));
    return Weighed(place(point, piece, 0.0), vec4<f32>(colour * weight, weight));
}

@fragment
fn density_fragment(in: Weighed) -> @location(0) vec4<f32> {
    return in.sum;
}
