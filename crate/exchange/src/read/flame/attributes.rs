//! The attributes of a tag.

use quick_xml::events::BytesStart;
use quick_xml::events::attributes::Attributes;

/// Those that are miswritten among them. That none comes twice is not asked, which would take the square of their
/// number.
pub fn all_attributes<'a>(tag: &'a BytesStart<'_>) -> Attributes<'a> {
    let text: &str = tag;
    let mut all = Attributes::new(text, tag.name().as_ref().len());
    all.with_checks(false);
    all
}

/// Their names and values, as they are written.
pub fn attributes<'a>(tag: &'a BytesStart<'_>) -> impl Iterator<Item = (&'a str, &'a str)> {
    all_attributes(tag).flatten().filter_map(|attribute| match attribute.value {
        std::borrow::Cow::Borrowed(value) => Some((attribute.key.into_inner(), value)),
        std::borrow::Cow::Owned(_) => None,
    })
}
