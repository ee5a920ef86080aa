// A photograph on a sheet of triangles. CPU twin: src/sheet.rs.

struct Shown {
    // Width and height of what is drawn to, in pixels.
    size: vec2<f32>,
    // Pixels of it for each one shown, each way.
    factor: i32,
    // 1 where colours are to be multiplied by alpha.
    premultiply: f32,
}

@group(0) @binding(0) var<uniform> shown: Shown;
@group(0) @binding(1) var photo: texture_2d<f32>;
@group(0) @binding(2) var between: sampler;

struct Corner {
    // In pixels from the upper left.
    @location(0) at: vec2<f32>,
    // Of the photograph, whose lower right corner is (1, 1).
    @location(1) place: vec2<f32>,
}

struct Placed {
    @builtin(position) position: vec4<f32>,
    @location(0) place: vec2<f32>,
}

@vertex
fn sheet_vertex(corner: Corner) -> Placed {
    let part = corner.at / shown.size;
    return Placed(vec4<f32>(part.x * 2.0 - 1.0, 1.0 - part.y * 2.0, 0.0, 1.0), corner.place);
}

// Premultiplied, as the photograph is.
@fragment
fn sheet_fragment(in: Placed) -> @location(0) vec4<f32> {
    return textureSample(photo, between, in.place);
}

@vertex
fn sheet_screen(@builtin(vertex_index) index: u32) -> @builtin(position) vec4<f32> {
    // One triangle that holds the whole screen.
    let corner = vec2<f32>(f32((index << 1u) & 2u), f32(index & 2u));
    return vec4<f32>(corner * 2.0 - 1.0, 0.0, 1.0);
}

@group(0) @binding(3) var drawn: texture_2d<f32>;

@fragment
fn sheet_resolve(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    let first = vec2<i32>(position.xy) * shown.factor;
    var sum = vec4<f32>(0.0);
    for (var y = 0; y < shown.factor; y++) {
        for (var x = 0; x < shown.factor; x++) {
            sum += textureLoad(drawn, first + vec2<i32>(x, y), 0);
        }
    }
    if sum.a <= 0.0 {
        return vec4<f32>(0.0);
    }
    let alpha = sum.a / f32(shown.factor * shown.factor);
    return vec4<f32>(sum.rgb / sum.a * (1.0 + (alpha - 1.0) * shown.premultiply), alpha);
}
