// Pictures as points of clouds, placed by pieces. CPU twin: src/splat/place.rs.

struct Job {
    // Places of a row.
    width: u32,
    // The letters of a code that are kept.
    kept: u32,
    pieces: u32,
    unused: u32,
}

// Scalars: a vector would leave gaps.
struct Piece {
    // The linear part, row by row, 16 bits each: high parts, and low ones, which are parts of those of 2^-14.
    along: u32,
    along_low: u32,
    down: u32,
    down_low: u32,
    // From the first pixel of its box, in parts of a pixel that wrap around.
    x: u32,
    y: u32,
    // The place of that pixel.
    corner: u32,
    // The pixels of the box each way, 16 bits each.
    size: u32,
    // The first letters of its word, three times six bits, and their count from bit 18 on.
    letters: u32,
    // The first of its points, and how many there are.
    first: u32,
    count: u32,
}

struct Point {
    // Where it is, 16 bits a coordinate: high parts, and low ones.
    at: u32,
    at_low: u32,
    // The first letters of its address.
    letters: u32,
}

@group(0) @binding(0) var<uniform> job: Job;
@group(0) @binding(1) var<storage, read> pieces: array<Piece>;
@group(0) @binding(2) var<storage, read> points: array<Point>;
@group(0) @binding(3) var<storage, read_write> codes: array<atomic<u32>>;

fn coordinates(packed: u32) -> vec2<i32> {
    let word = bitcast<i32>(packed);
    return vec2<i32>((word << 16u) >> 16u, word >> 16u);
}

fn dot_of(row: vec2<i32>, at: vec2<i32>) -> i32 {
    return row.x * at.x + row.y * at.y;
}

// Whole numbers are the same on every card; floats may be fused.
fn place(row: vec2<i32>, row_low: vec2<i32>, at: vec2<i32>, at_low: vec2<i32>, start: u32) -> u32 {
    let rest = (dot_of(row_low, at) + dot_of(row, at_low)) >> 14u;
    return (bitcast<u32>(dot_of(row, at) + rest) + start) >> 25u;
}

// A group takes a piece, so that no two of its points go different ways.
@compute @workgroup_size(128)
fn splat(
    @builtin(workgroup_id) group: vec3<u32>,
    @builtin(num_workgroups) groups: vec3<u32>,
    @builtin(local_invocation_index) lane: u32,
) {
    let index = group.y * groups.x + group.x;
    if index >= job.pieces {
        return;
    }
    let piece = pieces[index];
    let along = coordinates(piece.along);
    let along_low = coordinates(piece.along_low);
    let down = coordinates(piece.down);
    let down_low = coordinates(piece.down_low);
    let packed = piece.letters & 0x3ffffu;
    let shift = 6u * (piece.letters >> 18u);
    for (var i = lane; i < piece.count; i += 128u) {
        let point = points[piece.first + i];
        let at = coordinates(point.at);
        let at_low = coordinates(point.at_low);
        let x = place(along, along_low, at, at_low, piece.x);
        let y = place(down, down_low, at, at_low, piece.y);
        if x < (piece.size & 0xffffu) && y < (piece.size >> 16u) {
            let code = ((packed | (point.letters >> shift)) & job.kept) + 1u;
            // Later maps lie on top, in whatever order they come.
            atomicMax(&codes[piece.corner + y * job.width + x], code);
        }
    }
}
