//! The link in a picture.

use frond_exchange::{link_in_png, png_with_link};

use crate::reader::Reader;

/// The link in a picture.
pub const PNG: Reader = Reader {
    name: "png",
    read,
    words: &[
        "Frond link\0\0\0\0\0v=1&a=fern",
        "iTXt",
        "IHDR",
        "IDAT",
        "IEND",
        "#",
        "\0\0\0\x10",
        "\0\0\0\0",
        "\x7f",
    ],
};

fn read(bytes: &[u8]) {
    let found = link_in_png(bytes);
    let link = "v=1&a=koch&a-name=F%C3%BCr";
    // What cannot have a link is no picture; what has one has this one then, the first of its kind.
    let Some(with) = png_with_link(bytes, link) else { return };
    assert_eq!(link_in_png(&with).as_deref(), Some(link));
    let other = found.unwrap_or_else(|| "v=1".to_owned());
    let both = png_with_link(&with, &other).expect("a picture");
    let expected = other.split_once('#').map_or(&other[..], |(_, fragment)| fragment);
    assert_eq!(link_in_png(&both).as_deref(), Some(if expected.is_empty() { link } else { expected }));
}
