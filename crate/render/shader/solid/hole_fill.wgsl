// Closing the holes of a surface of points, with what shade.wgsl binds. CPU twin: src/solid/hole_fill.rs.

// A surface of points has holes while it moves: what most of the neighbours lie before is taken for one.
@fragment
fn hole_fill_fragment(@builtin(position) position: vec4<f32>) -> Kept {
    let at = vec2<i32>(position.xy);
    let own = depth_at(at);
    let slack = 6.0 / lamp.focal;
    var before = 0;
    var nearest = NOTHING_DEPTH;
    var source = at;
    for (var k = 0; k < 9; k++) {
        let next = at + vec2<i32>(k % 3 - 1, k / 3 - 1);
        let depth = depth_at(next);
        if depth < own - slack * depth {
            before++;
        }
        if depth < nearest {
            nearest = depth;
            source = next;
        }
    }
    if before < 5 {
        source = at;
    }
    if !inside(source) || code_at(source) == 0u {
        return Kept(0u, 0u);
    }
    // How far a point was spread is no longer of use.
    return Kept(textureLoad(codes, source, 0).r & 0xffffffu, textureLoad(depths, source, 0).r);
}
