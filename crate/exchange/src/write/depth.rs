//! How many images of images a list of points can hold.

/// How often all maps can be applied to a point until there are more points than this.
pub fn depth(maps: usize, most: usize) -> u32 {
    if maps < 2 { 12 } else { most.ilog(maps).max(1) }
}
