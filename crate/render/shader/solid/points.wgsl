// Clouds of points of space, placed by pieces and seen by a camera. What is nearest stays. CPU twin:
// src/solid/points.rs.

struct Eye {
    // Row by row, from space to what the eye sees: right, up, away; the last column moves.
    right: vec4<f32>,
    up: vec4<f32>,
    away: vec4<f32>,
    // Width and height of the target, in pixels.
    size: vec2<f32>,
    // Pixels a unit at depth 1.
    focal: f32,
    // The nearest depth that is seen.
    near: f32,
    // The farthest depth there is; the others are unused.
    far: vec4<f32>,
}

@group(0) @binding(0) var<uniform> eye: Eye;

struct Point {
    @location(0) position: vec3<f32>,
    // The first letters of its address: three times six bits.
    @location(1) letters: u32,
}

struct Piece {
    // Row by row, the translation last.
    @location(2) first: vec4<f32>,
    @location(3) second: vec4<f32>,
    @location(4) third: vec4<f32>,
    // As above, and their count from bit 18 on.
    @location(5) letters: u32,
    // The object's number, where codes have it.
    @location(6) object: u32,
}

struct Seen {
    @builtin(position) position: vec4<f32>,
    @location(0) @interpolate(flat, either) code: u32,
    @location(1) @interpolate(flat, either) depth: u32,
}

@vertex
fn points_vertex(point: Point, piece: Piece) -> Seen {
    let local = vec4<f32>(point.position, 1.0);
    let place = vec4<f32>(dot(piece.first, local), dot(piece.second, local), dot(piece.third, local), 1.0);
    let seen = vec3<f32>(dot(eye.right, place), dot(eye.up, place), dot(eye.away, place));
    let scale = eye.focal / seen.z;
    let pixel = floor(vec2<f32>(0.5 * eye.size.x + scale * seen.x, 0.5 * eye.size.y - scale * seen.y));
    let count = piece.letters >> 18u;
    let code = (piece.object | (piece.letters & 0x3ffffu) | (point.letters >> (6u * count))) + 1u;
    let inside = seen.z > eye.near && all(pixel >= vec2<f32>(0.0)) && all(pixel < eye.size);
    if !inside {
        // Outside of what is clipped.
        return Seen(vec4<f32>(2.0, 2.0, 0.0, 1.0), 0u, 0u);
    }
    let part = (pixel + 0.5) / eye.size;
    let depth = clamp((seen.z - eye.near) / (eye.far.x - eye.near), 0.0, 1.0);
    let position = vec4<f32>(part.x * 2.0 - 1.0, 1.0 - part.y * 2.0, depth, 1.0);
    return Seen(position, code, bitcast<u32>(seen.z));
}

@fragment
fn points_fragment(in: Seen) -> Kept {
    return Kept(in.code, in.depth);
}
