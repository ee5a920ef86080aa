// The connectedness locus, one invocation a sample. CPU twin: crate/locus/src/single.rs and what is under it, which
// says why each step is as it is; the two must stay the same, operation for operation.

struct Job {
    // The number of maps.
    maps: u32,
    // Relative to the diameter of an attractor.
    epsilon: f32,
    // Samples across, and rows in all.
    width: u32,
    height: u32,
    // The row to begin with.
    first: u32,
    padding0: u32,
    padding1: u32,
    padding2: u32,
}

@group(0) @binding(0) var<uniform> job: Job;
// Two for each map: the rows of its matrix; its translation, and bounds of the errors of both.
@group(0) @binding(1) var<storage, read> columns: array<vec4<f32>>;
@group(0) @binding(2) var<storage, read> rows: array<vec4<f32>>;
// The bits of the gap, with the number of the state in the lowest three.
@group(0) @binding(3) var<storage, read_write> answers: array<u32>;

const CONNECTED = 0u;
const TOUCHING = 1u;
const DISCONNECTED = 2u;
const UNDECIDED = 3u;

const ULP = 1.1920929e-7;
const SMALLEST_DIVISOR = 1e-30;
const SMALLEST_LENGTH = 1e-37;
const FAR = 1e9;
const MAX_MAPS = 8u;

// --- The table of support values: src/single/support.rs.

const DIRECTIONS_A_SIDE = 8u;
const HALF_SIDE = 4.0;
const DIRECTIONS = 32u;
const SUPPORT_ERROR = 32.0 * ULP;
const HALF_STEP_COSINE = 0.9925075;

var<private> count: u32;
var<private> linear: array<vec4<f32>, 8>;
var<private> shift: array<vec2<f32>, 8>;
var<private> values: array<f32, 32>;
var<private> points: array<vec2<f32>, 32>;

fn image(m: vec4<f32>, p: vec2<f32>) -> vec2<f32> {
    return vec2<f32>(m.x * p.x + m.y * p.y, m.z * p.x + m.w * p.y);
}

fn pulled(m: vec4<f32>, d: vec2<f32>) -> vec2<f32> {
    return vec2<f32>(m.x * d.x + m.z * d.y, m.y * d.x + m.w * d.y);
}

fn product(a: vec4<f32>, b: vec4<f32>) -> vec4<f32> {
    return vec4<f32>(
        a.x * b.x + a.y * b.z,
        a.x * b.y + a.y * b.w,
        a.z * b.x + a.w * b.z,
        a.z * b.y + a.w * b.w,
    );
}

fn norm(m: vec4<f32>) -> f32 {
    let turning = vec2<f32>(m.x + m.w, m.z - m.y);
    let flipping = vec2<f32>(m.x - m.w, m.z + m.y);
    return 0.5 * (sqrt(dot(turning, turning)) + sqrt(dot(flipping, flipping)));
}

fn direction(k: u32) -> vec2<f32> {
    let s = f32(k % DIRECTIONS_A_SIDE) * (1.0 / HALF_SIDE) - 1.0;
    switch k / DIRECTIONS_A_SIDE {
        case 0u: { return vec2<f32>(1.0, s); }
        case 1u: { return vec2<f32>(-s, 1.0); }
        case 2u: { return vec2<f32>(-1.0, -s); }
        default: { return vec2<f32>(s, -1.0); }
    }
}

struct Support {
    reach: f32,
    near: u32,
}

fn support(d: vec2<f32>) -> Support {
    let steep = abs(d.x) < abs(d.y);
    let large = select(d.x, d.y, steep);
    let small = select(d.y, -d.x, steep);
    let length = abs(large);
    let usual = length >= SMALLEST_LENGTH;
    let slope = select(0.0, small / select(1.0, large, usual), usual);
    let along = slope * HALF_SIDE + HALF_SIDE;
    let sector = clamp(floor(along), 0.0, 2.0 * HALF_SIDE - 1.0);
    let part = along - sector;
    let side = select(0u, 2u, large < 0.0) + select(0u, 1u, steep);
    let low = side * DIRECTIONS_A_SIDE + u32(sector);
    let high = (low + 1u) % DIRECTIONS;
    let a = values[low];
    let b = values[high];
    return Support(length * (a + part * (b - a)), select(low, high, part > 0.5));
}

fn make_table(start: vec2<f32>, accuracy: f32) {
    for (var k = 0u; k < DIRECTIONS; k++) {
        let d = direction(k);
        values[k] = sqrt(dot(d, d)) * (1.0 + SUPPORT_ERROR);
        points[k] = start;
    }
    for (var round = 0u; round < SUPPORT_ROUNDS; round++) {
        var change = 0.0;
        for (var k = 0u; k < DIRECTIONS; k++) {
            let d = direction(k);
            var best = -4.0;
            var image_point = vec2<f32>(0.0);
            for (var i = 0u; i < count; i++) {
                let far = support(pulled(linear[i], d));
                let value = far.reach + dot(shift[i], d);
                if value > best {
                    best = value;
                    image_point = image(linear[i], points[far.near]) + shift[i];
                }
            }
            points[k] = image_point;
            best += 1.5 * SUPPORT_ERROR;
            let fall = values[k] - best;
            if fall > 0.0 {
                change = max(change, fall);
                values[k] = best;
            }
        }
        if change < accuracy {
            break;
        }
    }
    for (var k = 0u; k < DIRECTIONS; k++) {
        values[k] += 1.5 * SUPPORT_ERROR;
    }
}

fn table_diameter() -> f32 {
    var widest = 0.0;
    for (var k = 0u; k < DIRECTIONS / 2u; k++) {
        let d = direction(k);
        widest = max(widest, (values[k] + values[k + DIRECTIONS / 2u]) / sqrt(dot(d, d)));
    }
    return widest / HALF_STEP_COSINE;
}

// --- The descent on pairs of words: src/single/descent.rs.

const STACK_SIZE = 64u;
const DIRECTIONS_PER_PAIR = 2u;

const APART = 1u;
const MET = 2u;
const UNKNOWN = 3u;

struct Pair {
    a: vec4<f32>,
    b: vec4<f32>,
    step: vec2<f32>,
}

struct Look {
    apart: f32,
    overlap: f32,
    reach: f32,
}

var<private> margin: f32;
var<private> resolution: f32;
var<private> looks: u32;
var<private> nearest: f32;
var<private> lower: f32;
var<private> stack: array<Pair, 64>;
var<private> plans: array<u32, 64>;

fn look(pair: Pair) -> Look {
    var seen = Look(0.0, FAR, FAR);
    var normal = pair.step;
    for (var round = 0u; round < DIRECTIONS_PER_PAIR; round++) {
        let far_a = support(pulled(pair.a, normal));
        let far_b = support(-pulled(pair.b, normal));
        let along = dot(normal, pair.step);
        let far = far_a.reach + far_b.reach;
        let between = pair.step + image(pair.b, points[far_b.near]) - image(pair.a, points[far_a.near]);
        seen.reach = min(seen.reach, dot(between, between));
        let length = sqrt(dot(normal, normal));
        let off = along - far - margin * length;
        if off > 0.0 {
            seen.apart = off / length;
            return seen;
        }
        seen.overlap = min(seen.overlap, along / max(far, SMALLEST_DIVISOR));
        let turn = normal - between;
        let t = clamp(dot(normal, turn) / max(dot(turn, turn), SMALLEST_DIVISOR), 0.0, 1.0);
        normal -= turn * t;
    }
    return seen;
}

fn part_of(whole: Pair, index: u32, first: bool) -> Pair {
    if first {
        return Pair(product(whole.a, linear[index]), whole.b, whole.step - image(whole.a, shift[index]));
    }
    return Pair(whole.a, product(whole.b, linear[index]), whole.step + image(whole.b, shift[index]));
}

fn touch(reach: f32) -> bool {
    return reach <= resolution * resolution;
}

fn descend(root: Pair, shade: f32, limit: u32) -> u32 {
    var level = 0u;
    // The first level that is still remembered.
    var floor_level = 0u;
    stack[0] = root;
    var fresh = true;
    lower = FAR;
    loop {
        let pair = stack[level % STACK_SIZE];
        if fresh {
            let sizes = norm(pair.a) + norm(pair.b);
            if sizes <= job.epsilon && shade == 0.0 {
                return MET;
            }
            if sizes <= margin || looks >= limit {
                break;
            }
            let first = dot(pair.a, pair.a) >= dot(pair.b, pair.b);
            var keys = array<f32, 8>(FAR, FAR, FAR, FAR, FAR, FAR, FAR, FAR);
            var kept = 0u;
            for (var index = 0u; index < count; index++) {
                let seen = look(part_of(pair, index, first));
                looks += 1u;
                nearest = min(nearest, seen.reach);
                if touch(seen.reach) {
                    return MET;
                }
                if seen.apart > 0.0 && seen.apart * seen.apart >= shade * shade * nearest {
                    lower = min(lower, seen.apart);
                } else {
                    keys[index] = select(min(seen.overlap, 2.0), 2.0 + seen.apart, seen.apart > 0.0);
                    kept += 1u;
                }
            }
            var plan = (kept << 24u) | select(0u, 0x80000000u, first);
            for (var place = 0u; place < kept; place++) {
                var least = 0u;
                for (var index = 1u; index < count; index++) {
                    if keys[index] < keys[least] {
                        least = index;
                    }
                }
                keys[least] = FAR;
                plan |= least << (3u * place);
            }
            plans[level % STACK_SIZE] = plan;
        }
        let plan = plans[level % STACK_SIZE];
        if ((plan >> 24u) & 15u) == 0u {
            if level == floor_level {
                return select(UNKNOWN, APART, floor_level == 0u);
            }
            level -= 1u;
            fresh = false;
            continue;
        }
        let rest = (plan & 0x00ffffffu) >> 3u;
        plans[level % STACK_SIZE] = rest | ((plan & 0xff000000u) - 0x01000000u);
        level += 1u;
        floor_level = max(floor_level + STACK_SIZE, level + 1u) - STACK_SIZE;
        stack[level % STACK_SIZE] = part_of(pair, plan & 7u, (plan >> 31u) == 1u);
        fresh = true;
    }
    return UNKNOWN;
}

// --- One sample: src/single/system.rs and sample.rs.

const LARGEST_FACTOR = 0.97;
const SUPPORT_ROUNDS = 48u;
const LOOKS_TO_DECIDE = 3000u;
const LOOKS_TO_MEASURE = 400u;
const GAP_TIGHTNESS = 0.95;
const LARGEST_MARGIN = 0.01;
const PAIRS = 28u;
const OPEN = 0u;
const MEASURED = 4u;

struct Edge {
    reach: f32,
    lower: f32,
    overlap: f32,
    state: u32,
}

var<private> factor: f32;
// The most that a matrix was given with.
var<private> given: f32;
var<private> edges: array<Edge, 28>;
var<private> groups: array<u32, 8>;

fn fixed_point(m: vec4<f32>, t: vec2<f32>) -> vec2<f32> {
    let determinant = (1.0 - m.x) * (1.0 - m.w) - m.y * m.z;
    return vec2<f32>((1.0 - m.w) * t.x + m.y * t.y, m.z * t.x + (1.0 - m.x) * t.y) / determinant;
}

fn set_frame(column: u32, row: u32) -> bool {
    var mean_linear = vec4<f32>(0.0);
    var mean_shift = vec2<f32>(0.0);
    factor = 0.0;
    given = 0.0;
    for (var i = 0u; i < count; i++) {
        linear[i] = columns[2u * (column + i)] + rows[2u * (row + i)];
        let rest = columns[2u * (column + i) + 1u] + rows[2u * (row + i) + 1u];
        shift[i] = rest.xy;
        mean_linear += linear[i];
        mean_shift += shift[i];
        factor = max(factor, norm(linear[i]) * (1.0 + 16.0 * ULP) + rest.z);
        given = max(given, rest.z);
    }
    if factor >= LARGEST_FACTOR {
        return false;
    }
    let share = 1.0 / f32(count);
    let origin = fixed_point(mean_linear * share, mean_shift * share);
    let far = sqrt(dot(origin, origin));
    var widest = 0.0;
    var off = 0.0;
    for (var i = 0u; i < count; i++) {
        let own = columns[2u * (column + i) + 1u] + rows[2u * (row + i) + 1u];
        let size = sqrt(dot(shift[i], shift[i]));
        off = max(off, own.z * far + own.w + 5.0 * ULP * (2.5 * far + size));
        shift[i] = image(linear[i], origin) + shift[i] - origin;
        widest = max(widest, sqrt(dot(shift[i], shift[i])));
    }
    let rest = 1.0 - factor;
    let radius = (widest * (1.0 + 16.0 * ULP) + off) / rest * (1.0 + 16.0 * ULP);
    if radius <= 1e-12 {
        return false;
    }
    for (var i = 0u; i < count; i++) {
        shift[i] = shift[i] / radius;
    }
    let error = given + off / radius + 3.0 * ULP * rest;
    margin = 2.0 * error / rest + ULP * (20.0 + 15.0 * factor / rest);
    return margin < LARGEST_MARGIN;
}

fn area(m: vec4<f32>) -> f32 {
    return abs(m.x * m.w - m.y * m.z);
}

fn join(i: u32, j: u32) {
    let both = groups[i] | groups[j];
    for (var k = 0u; k < MAX_MAPS; k++) {
        if ((both >> k) & 1u) == 1u {
            groups[k] = both;
        }
    }
}

fn joined(i: u32, j: u32) -> bool {
    return ((groups[i] >> j) & 1u) == 1u;
}

fn whole() -> bool {
    return groups[0] == (1u << count) - 1u;
}

fn root(i: u32, j: u32) -> Pair {
    return Pair(linear[i], linear[j], shift[j] - shift[i]);
}

fn first_looks() {
    var k = 0u;
    for (var i = 0u; i < count; i++) {
        for (var j = i + 1u; j < count; j++) {
            let seen = look(root(i, j));
            looks += 1u;
            var state = select(OPEN, APART, seen.apart > 0.0);
            if touch(seen.reach) {
                join(i, j);
                state = MET;
            }
            edges[k] = Edge(seen.reach, seen.apart, seen.overlap, state);
            k += 1u;
        }
    }
}

// A pair of pieces that lie in two components: its number, PAIRS where there is none, and those of its pieces. Of the
// open pairs it is the one that overlaps most; to narrow the gap, of those whose bounds are wide apart, the one that
// is known to be nearest.
fn next_pair(narrowing: bool, above: f32) -> vec3<u32> {
    var best = vec3<u32>(PAIRS, 0u, 0u);
    var least = FAR;
    var k = 0u;
    for (var i = 0u; i < count; i++) {
        for (var j = i + 1u; j < count; j++) {
            let edge = edges[k];
            let loose = edge.state == APART && edge.lower < GAP_TIGHTNESS * min(sqrt(edge.reach), above);
            let key = select(edge.overlap, edge.reach, narrowing);
            if select(edge.state == OPEN, loose, narrowing) && key < least && !joined(i, j) {
                least = key;
                best = vec3<u32>(k, i, j);
            }
            k += 1u;
        }
    }
    return best;
}

fn settle() {
    while !whole() {
        let pair = next_pair(false, 0.0);
        let best = pair.x;
        if best == PAIRS {
            return;
        }
        nearest = edges[best].reach;
        let end = descend(root(pair.y, pair.z), 0.0, LOOKS_TO_DECIDE);
        edges[best].reach = nearest;
        edges[best].state = end;
        if end == MET {
            join(pair.y, pair.z);
        } else if end == APART {
            edges[best].lower = lower;
        }
    }
}

// By lower or by upper bounds.
fn widest_edge(by_lower: bool) -> f32 {
    let all = (1u << count) - 1u;
    var reached = groups[0];
    var widest = 0.0;
    for (var n = 1u; n < count; n++) {
        if reached == all {
            break;
        }
        var least = FAR;
        var next = 0u;
        var k = 0u;
        for (var i = 0u; i < count; i++) {
            for (var j = i + 1u; j < count; j++) {
                let inner = ((reached >> i) & 1u) == 1u;
                let outer = ((reached >> j) & 1u) == 1u;
                let distance = select(sqrt(edges[k].reach), edges[k].lower, by_lower);
                if inner != outer && distance <= least {
                    least = distance;
                    next = select(i, j, inner);
                }
                k += 1u;
            }
        }
        reached |= groups[next];
        widest = max(widest, least);
    }
    return widest;
}

// Below 0 where the bounds contradict each other.
fn measure() -> f32 {
    let limit = looks + LOOKS_TO_MEASURE;
    var above = 0.0;
    loop {
        above = widest_edge(false);
        let pair = next_pair(true, above);
        let best = pair.x;
        if best == PAIRS || looks >= limit {
            break;
        }
        nearest = edges[best].reach;
        let end = descend(root(pair.y, pair.z), GAP_TIGHTNESS, limit);
        edges[best].reach = nearest;
        if end == APART {
            edges[best].lower = max(edges[best].lower, lower);
        }
        edges[best].state = MEASURED;
    }
    let below = widest_edge(true);
    return select(-1.0, 0.5 * (above + below), below <= above + margin);
}

fn decide(x: u32, y: u32) -> u32 {
    count = job.maps;
    if !set_frame(x * count, y * count) {
        return UNDECIDED;
    }
    if count == 1u {
        return CONNECTED;
    }
    if count == 2u {
        let spare = area(linear[0]) + area(linear[1]) - 1.0;
        let slack = 16.0 * ULP + 16.0 * given;
        if spare >= slack {
            return CONNECTED;
        }
        if spare >= -slack {
            return UNDECIDED;
        }
    }
    make_table(fixed_point(linear[0], shift[0]), 0.03 * (1.0 - factor));
    let diameter = table_diameter();
    resolution = job.epsilon * diameter;
    looks = 0u;
    for (var i = 0u; i < MAX_MAPS; i++) {
        groups[i] = 1u << i;
    }
    first_looks();
    settle();
    if whole() {
        return TOUCHING;
    }
    // If all that is not known should meet.
    let found = groups;
    var k = 0u;
    for (var i = 0u; i < count; i++) {
        for (var j = i + 1u; j < count; j++) {
            if edges[k].state == UNKNOWN || edges[k].state == OPEN {
                join(i, j);
            }
            k += 1u;
        }
    }
    if whole() {
        return UNDECIDED;
    }
    groups = found;
    let gap = measure() / diameter;
    if !(gap >= 0.0 && gap <= 1.0) {
        return UNDECIDED;
    }
    return (bitcast<u32>(gap) & 0xfffffff8u) | DISCONNECTED;
}

@compute @workgroup_size(8, 8)
fn decide_samples(@builtin(global_invocation_id) id: vec3<u32>) {
    let y = job.first + id.y;
    if id.x >= job.width || y >= job.height {
        return;
    }
    answers[y * job.width + id.x] = decide(id.x, y);
}
