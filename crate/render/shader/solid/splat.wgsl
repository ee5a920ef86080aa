// Points as large as the space between them: each is offered to the pixels a step away. CPU twin: src/solid/splat.rs.

struct SplatStep {
    // Width and height, in pixels.
    size: vec2<i32>,
    // Pixels a unit at depth 1.
    focal: f32,
    // The length of a step, in pixels.
    step: i32,
    // The space between the points of each object, in units of space.
    gaps: array<vec4<f32>, 15>,
}

@group(0) @binding(0) var<uniform> splat: SplatStep;
@group(0) @binding(2) var codes: texture_2d<u32>;
@group(0) @binding(3) var depths: texture_2d<u32>;

struct Offer {
    code: u32,
    depth: f32,
    // Half pixels that it has come, and may come.
    come: u32,
    reach: u32,
    gap: f32,
}

fn offer_at(at: vec2<i32>, come: u32) -> Offer {
    var code = 0u;
    if all(at >= vec2<i32>(0)) && all(at < splat.size) {
        code = textureLoad(codes, at, 0).r;
    }
    if code == 0u {
        return Offer(0u, 0.0, come, 0u, 0.0);
    }
    let depth = bitcast<f32>(textureLoad(depths, at, 0).r);
    let object = min(((code & 0xffffffu) - 1u) >> 18u, 59u);
    let gap = splat.gaps[object / 4u][object % 4u];
    let reach = u32(min(2.0 * gap * splat.focal / depth, 255.0));
    return Offer(code, depth, come + (code >> 24u), reach, gap);
}

// What is clearly nearer is rather seen, and of one surface what has come less far.
fn before(a: Offer, b: Offer) -> bool {
    if b.code == 0u || a.depth + 2.0 * a.gap < b.depth {
        return true;
    }
    return b.depth + 2.0 * b.gap >= a.depth && a.come < b.come;
}

@fragment
fn splat_fragment(@builtin(position) position: vec4<f32>) -> Kept {
    let at = vec2<i32>(position.xy);
    var best = offer_at(at, 0u);
    for (var k = 0; k < 9; k++) {
        let off = vec2<i32>(k % 3 - 1, k / 3 - 1);
        if k != 4 {
            let far = select(2.0, 2.828427, off.x != 0 && off.y != 0);
            let next = offer_at(at + splat.step * off, u32(round(far * f32(splat.step))));
            if next.code != 0u && next.come <= next.reach && before(next, best) {
                best = next;
            }
        }
    }
    if best.code == 0u {
        return Kept(0u, 0u);
    }
    return Kept((best.code & 0xffffffu) | (min(best.come, 255u) << 24u), bitcast<u32>(best.depth));
}
