//! Addresses that repeat.

use frond_core::Affine2;
use glam::DVec2;

/// An endless address that repeats itself from some letter on: `head` once, then `repeat` without end. Letters from 0.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Address {
    pub head: Vec<u8>,
    pub repeat: Vec<u8>,
}

impl Address {
    /// The same address with the shortest repeat, beginning as early as can be. `None` if nothing is repeated.
    pub fn new(mut head: Vec<u8>, mut repeat: Vec<u8>) -> Option<Self> {
        let count = repeat.len();
        let period = (1..=count)
            .find(|&p| count.is_multiple_of(p) && (p..count).all(|k| repeat[k] == repeat[k - p]))?;
        repeat.truncate(period);
        while head.last().is_some_and(|last| Some(last) == repeat.last()) {
            head.pop();
            repeat.rotate_right(1);
        }
        Some(Self { head, repeat })
    }

    /// The map whose piece the point is in.
    pub fn first(&self) -> usize {
        usize::from(*self.head.first().unwrap_or(&self.repeat[0]))
    }

    /// The point, to rounding.
    pub fn point(&self, maps: &[Affine2]) -> Option<DVec2> {
        let map = |i: &u8| maps[usize::from(*i)];
        let fixed = self.repeat.iter().fold(Affine2::IDENTITY, |word, i| word * map(i)).fixed_point()?;
        Some(self.head.iter().rev().fold(fixed, |point, i| map(i).apply(point)))
    }

    /// As people read it: letters from 1, "1(2)" for 1222.. Of more than nine maps letters are joined by dots, and
    /// one stands before the bracket, so that "12.3.(10)" and ".(12)" cannot be taken for other letters.
    pub fn shown(&self, maps: usize) -> String {
        let dot = if maps > 9 { "." } else { "" };
        format!("{}{dot}({})", shown(&self.head, maps), shown(&self.repeat, maps))
    }

    /// Reads what is shown.
    #[cfg(test)]
    pub fn parse(text: &str) -> Option<Self> {
        let (head, repeat) = text.strip_suffix(')')?.split_once('(')?;
        let letter = |n: &str| n.parse::<u8>().ok()?.checked_sub(1);
        let letters = |part: &str| -> Option<Vec<u8>> {
            if text.contains('.') {
                part.split('.').filter(|n| !n.is_empty()).map(letter).collect()
            } else {
                part.split("").filter(|n| !n.is_empty()).map(letter).collect()
            }
        };
        Some(Self { head: letters(head)?, repeat: letters(repeat)? })
    }
}

/// A word as people read it beside such addresses.
pub(crate) fn shown(word: &[u8], maps: usize) -> String {
    let letters: Vec<String> = word.iter().map(|i| (usize::from(*i) + 1).to_string()).collect();
    letters.join(if maps > 9 { "." } else { "" })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn addresses_take_their_shortest_form() {
        let shown =
            |head: &[u8], repeat: &[u8]| Address::new(head.to_vec(), repeat.to_vec()).unwrap().shown(9);
        assert_eq!(shown(&[0], &[1, 1, 1]), "1(2)");
        assert_eq!(shown(&[0, 1], &[1]), "1(2)");
        assert_eq!(shown(&[1, 1], &[1]), "(2)");
        assert_eq!(shown(&[0, 1, 2], &[1, 2, 1, 2]), "1(23)");
        assert_eq!(shown(&[0, 2], &[1, 2]), "1(32)");
        assert_eq!(Address::new(vec![9, 0], vec![1, 10]).unwrap().shown(64), "10.1.(2.11)");
        assert_eq!(Address::new(vec![1], vec![]), None);
    }

    #[test]
    fn what_is_shown_is_read_as_it_was() {
        let words = |letters: &[u8]| -> Vec<Vec<u8>> {
            let one = letters.iter().map(|&a| vec![a]);
            one.chain(letters.iter().flat_map(|&a| letters.iter().map(move |&b| vec![a, b]))).collect()
        };
        for (maps, letters) in [(9, &[0_u8, 1, 8][..]), (10, &[0, 1, 8, 9]), (64, &[0, 1, 10, 11, 62, 63])] {
            for head in words(letters).into_iter().chain([vec![]]) {
                for repeat in words(letters) {
                    let Some(address) = Address::new(head.clone(), repeat) else { continue };
                    let text = address.shown(maps);
                    assert_eq!(Address::parse(&text), Some(address), "{text}");
                }
            }
        }
        assert_eq!(Address::new(vec![], vec![11]).unwrap().shown(12), ".(12)");
        assert_eq!(
            [Address::parse("1(0)"), Address::parse("1.(x)"), Address::parse("12")],
            [None, None, None]
        );
    }

    #[test]
    fn points_follow_the_letters() {
        let maps = [0.0, 0.5].map(|e| Affine2::from_row([0.5, 0.0, 0.0, 0.5, e, 0.0]));
        let at = |text: &str| Address::parse(text).unwrap().point(&maps).unwrap().x;
        assert_eq!((at("1(2)"), at("2(1)"), at("(2)")), (0.5, 0.5, 1.0));
        // Binary 0.0101.. is a third.
        assert!((at("(12)") - 1.0 / 3.0).abs() < 1e-15);
    }
}
