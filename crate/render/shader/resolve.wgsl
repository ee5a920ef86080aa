// From what was drawn to the picture that is shown. CPU twin: src/resolve.rs.

@vertex
fn screen_vertex(@builtin(vertex_index) index: u32) -> @builtin(position) vec4<f32> {
    // One triangle that holds the whole screen.
    let corner = vec2<f32>(f32((index << 1u) & 2u), f32(index & 2u));
    return vec4<f32>(corner * 2.0 - 1.0, 0.0, 1.0);
}

struct Taps {
    base: vec2<i32>,
    part: vec2<f32>,
}

fn taps_of(position: vec4<f32>) -> Taps {
    // The position is the middle of the pixel.
    let at = position.xy * look.factor - 0.5;
    let base = floor(at);
    return Taps(vec2<i32>(base), at - base);
}

fn tap(taps: Taps, k: i32) -> vec2<i32> {
    return clamp(taps.base + vec2<i32>(k & 1, k >> 1u), vec2<i32>(0), look.source - 1);
}

fn weight_of(taps: Taps, k: i32) -> f32 {
    let along = select(1.0 - taps.part, taps.part, vec2<bool>((k & 1) == 1, (k >> 1u) == 1));
    return along.x * along.y;
}

fn finish(sum: vec4<f32>, alpha: f32, light: f32) -> vec4<f32> {
    if sum.a <= 0.0 {
        return vec4<f32>(0.0);
    }
    let scale = 1.0 + (alpha - 1.0) * look.premultiply;
    let mean = sum.rgb / sum.a;
    return vec4<f32>((mean + (1.0 - mean) * light) * scale, alpha);
}

@group(0) @binding(2) var codes: texture_2d<u32>;

@fragment
fn codes_resolve(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    let taps = taps_of(position);
    var sum = vec4<f32>(0.0);
    for (var k = 0; k < 4; k++) {
        let code = textureLoad(codes, tap(taps, k), 0).r;
        let weight = weight_of(taps, k);
        if code > 0u && weight > 0.0 {
            sum += weight * vec4<f32>(colour_of(code), 1.0);
        }
    }
    return finish(sum, cover(sum.a), 0.0);
}

@group(0) @binding(3) var sums: texture_2d<f32>;

@fragment
fn density_resolve(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    let taps = taps_of(position);
    var sum = vec4<f32>(0.0);
    for (var k = 0; k < 4; k++) {
        // Half floats end at 65504; what is beyond would be infinite, and so no colour.
        let texel = min(textureLoad(sums, tap(taps, k), 0), vec4<f32>(65504.0));
        sum += weight_of(taps, k) * texel;
    }
    let alpha = tone(sum.a * look.gain);
    return finish(sum, alpha, glow(alpha));
}
