// From what was drawn to the picture that is shown. CPU twin: src/picture/resolve.rs.

struct Taps {
    base: vec2<i32>,
    part: vec2<f32>,
}

fn taps_of(position: vec4<f32>) -> Taps {
    // The position is the middle of the pixel.
    let at = position.xy * colours.factor - 0.5;
    let base = floor(at);
    return Taps(vec2<i32>(base), at - base);
}

fn tap(taps: Taps, k: i32) -> vec2<i32> {
    return clamp(taps.base + vec2<i32>(k & 1, k >> 1u), vec2<i32>(0), colours.source - 1);
}

fn weight_of(taps: Taps, k: i32) -> f32 {
    let along = select(1.0 - taps.part, taps.part, vec2<bool>((k & 1) == 1, (k >> 1u) == 1));
    return along.x * along.y;
}

fn finish(sum: vec4<f32>, alpha: f32, light: f32) -> vec4<f32> {
    if sum.a <= 0.0 {
        return vec4<f32>(0.0);
    }
    let scale = 1.0 + (alpha - 1.0) * colours.premultiply;
    let mean = sum.rgb / sum.a;
    return vec4<f32>((mean + (colours.towards - mean) * light) * scale, alpha);
}

@group(0) @binding(2) var codes: texture_2d<u32>;

fn code_at(taps: Taps, k: i32) -> u32 {
    return textureLoad(codes, tap(taps, k), 0).r;
}

// A pixel that is all of one piece, or of none.
fn whole(code: u32) -> vec4<f32> {
    if code == 0u {
        return vec4<f32>(0.0);
    }
    return vec4<f32>(colour_of(code), 1.0);
}

fn add(sum: vec4<f32>, code: u32, weight: f32) -> vec4<f32> {
    return sum + weight * whole(code);
}

@fragment
fn codes_resolve(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    let taps = taps_of(position);
    let first = code_at(taps, 0);
    // Most pixels are settled by one of these, and where there is no graphics card each tap is dear.
    if all(taps.part == vec2<f32>(0.0)) {
        return whole(first);
    }
    let second = code_at(taps, 1);
    let third = code_at(taps, 2);
    let fourth = code_at(taps, 3);
    if first == second && first == third && first == fourth {
        return whole(first);
    }
    var sum = add(vec4<f32>(0.0), first, weight_of(taps, 0));
    sum = add(sum, second, weight_of(taps, 1));
    sum = add(sum, third, weight_of(taps, 2));
    sum = add(sum, fourth, weight_of(taps, 3));
    return finish(sum, cover(sum.a), 0.0);
}

@group(0) @binding(3) var sums: texture_2d<f32>;

@fragment
fn density_resolve(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    // Sums have the size of the picture.
    // Half floats end at 65504; what is beyond would be infinite, and so no colour.
    let sum = min(textureLoad(sums, vec2<i32>(position.xy), 0), vec4<f32>(65504.0));
    let density = sum.a * colours.gain;
    let response = respond(density, colours.slope);
    return finish(sum, tone(density, response), glow(response));
}

// A picture that was made on the processor, by the twins of the above.
@group(0) @binding(4) var picture: texture_2d<f32>;

@fragment
fn picture_resolve(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    let pixel = textureLoad(picture, vec2<i32>(position.xy), 0);
    let scale = 1.0 + (pixel.a - 1.0) * colours.premultiply;
    return vec4<f32>(pixel.rgb * scale, pixel.a);
}
