// What a pixel of space keeps.

struct Kept {
    @location(0) code: u32,
    // The bits of an f32.
    @location(1) depth: u32,
}
