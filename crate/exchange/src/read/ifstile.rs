//! `.aifs` files of IFStile: a part of them, as [`blocks::SUBSET`] says it to whoever opens one.
//!
//! A file has blocks, `@id:parent`, of definitions `name=value`; a block has those of its parent, too. `[x, y]` is a
//! translation and `[a, b, c, d]` a matrix, `*` composes, `|` unites, and the shape is a set that is made of its own
//! images: `S=(f|g)*S`. Nothing in a file is run: what is not listed is refused, with its line.

mod blocks;
mod scope;
mod value;

use super::problem::{Gathered, ImportError, MAX_SYSTEMS};
use crate::system::System;
use blocks::{Block, MAX_BLOCKS, blocks, refused};
use scope::{MAX_DEPTH, Scope};

/// Steps of arithmetic for one block, and for all of a file.
const MAX_STEPS: usize = 20_000;
const MAX_FILE_STEPS: usize = 2_000_000;

/// Reads the blocks that have an equation of a set.
pub fn read_ifstile(text: &str) -> Result<Gathered, ImportError> {
    let blocks = blocks(text)?;
    let mut all = Gathered::default();
    let count = text.lines().filter(|line| line.trim_start().starts_with('@')).count();
    if count > MAX_BLOCKS {
        all.remarks.push(format!("The file has {count} blocks: the first {MAX_BLOCKS} are looked at."));
    }
    let mut left = MAX_FILE_STEPS;
    for (k, block) in blocks.iter().enumerate() {
        if left == 0 {
            let line = block.line;
            all.remarks.push(format!("The file takes too many steps to compute: it is read to line {line}."));
            break;
        }
        // What others are built on is hidden, and may not be complete.
        if !block.hidden() && all.systems.len() < MAX_SYSTEMS {
            all.extend_with(system(&blocks, k, &mut left));
        }
    }
    all.finish(refused("aifs-nothing", 1, "No block has an equation of a set."))
}

/// The system of a block; nothing where it has no set. What steps it takes are taken from those that are left.
fn system<'a>(blocks: &'a [Block<'a>], k: usize, left: &mut usize) -> Option<Result<System, ImportError>> {
    let most = MAX_STEPS.min(*left);
    let mut scope = Scope { chain: Vec::new(), size: 2, set: "", line: blocks[k].line, steps: 0, most };
    let mut next = Some(k);
    while let Some(block) = next.filter(|_| scope.chain.len() < MAX_DEPTH) {
        scope.chain.push(&blocks[block]);
        next = blocks[block].parent;
    }
    let found = scope.find_set().and_then(|set| {
        scope.set = set.unwrap_or_default();
        set.map(|_| scope.read()).transpose()
    });
    *left -= scope.steps.min(*left);
    found.transpose()
}

#[cfg(test)]
mod tests {
    use super::blocks::SUBSET;
    use super::*;
    use crate::system::Maps;

    fn rows(text: &str) -> Vec<[f64; 6]> {
        match read_ifstile(text).unwrap().systems.remove(0).maps {
            Maps::Plane(rows) => rows,
            Maps::Space(_) => Vec::new(),
        }
    }

    fn told(text: &str) -> String {
        read_ifstile(text).map(|_| ()).unwrap_err().to_string()
    }

    #[test]
    fn an_equation_of_a_set_is_a_system() {
        let dragon = [[0.5, -0.5, 0.5, 0.5, 0.0, 0.0], [-0.5, -0.5, 0.5, -0.5, 1.0, 0.0]];
        for text in [
            "@\n$dim=2\nf1=[0,0]*[0.5,-0.5,0.5,0.5]\nf2=[1,0]*[-0.5,-0.5,0.5,-0.5]\nS=(f1|f2)*S",
            "@@version 4\n@ # by hand\nA = [.5,-1/2,2^-1,0.5]*A | [1,0] * [-.5,-.5,5e-1,-.5] * A\r\n",
            "@base\n$a=h\nh=2^-1\nS=(f|g)*S\n@:base\n$dim=2\n$n=Dragon\nf=h*[1,-1,1,1]\ng=[1,0]*h*[-1,-1,1,-1]",
        ] {
            assert_eq!(rows(text), dragon, "{text}");
        }
        // A scale before a shift scales it, too.
        assert_eq!(
            rows("@\nA=(2^-1*[1,0]|[1,0]*2^-1)*A"),
            [[0.5, 0.0, 0.0, 0.5, 0.5, 0.0], [0.5, 0.0, 0.0, 0.5, 1.0, 0.0]]
        );
        assert_eq!(rows("@\nf=[.5,0,0,.5]\ng=[1,0]\nA=f^2*A|f*g*A|-f*A").len(), 3);
        let solid = read_ifstile("@\n$dim=3\nA=([1,0,0]|[0,0,0])*2^-1*A").unwrap().systems.remove(0);
        assert_eq!(solid.maps.len(), 2);
    }

    #[test]
    fn hidden_blocks_are_no_shapes_of_their_own() {
        let found = |letter: char| read_ifstile(&format!("@b\n$a={letter}\nA=[.5,0,0,.5]*A\n@:b\n$n=Two\n"));
        let names = |letter| found(letter).unwrap().systems.into_iter().map(|it| it.name).collect::<Vec<_>>();
        assert_eq!(names('h'), ["Two"]);
        assert_eq!(names('x'), ["", "Two"]);
    }

    #[test]
    fn a_set_is_what_mentions_itself_where_it_is_last_defined() {
        let half = "[.5,0,0,.5]";
        assert_eq!(rows(&format!("@b\nA={half}*A\nB=(1|A)*B\n@:b\nA={half}\n"))[1][0], 0.5);
        assert_eq!(rows(&format!("@\nA=A*A\nA={half}\nB=A*B\n")).len(), 1);
        assert!(told(&format!("@\nA={half}*A\nB={half}*B\n")).contains("“A” and “B” are two sets."));
    }

    #[test]
    fn what_is_not_read_is_told_with_its_line() {
        for (text, start) in [
            ("@\n$dim=2\n$subspace=[s,0]\nA=A", "Line 3: $subspace"),
            ("@\n$dim=4\nA=A", "Line 2: $dim"),
            ("@\ns=$companion([1,1])\nA=s*A", "Line 2: “$companion(”"),
            ("@\nA=h*A\nh=k", "Line 3: “k”"),
            ("@\nA=h*B|A\nB=h*A|B", "Line 1: “A” and “B” are two sets."),
            ("@\nA=[1,0*A", "Line 2: Lists"),
            ("@\nA=[1,2,3]*A", "Line 2: A list of 3 numbers"),
            ("@\nA=(1|2|3|4|5)^3*A", "Line 2: There are more than 64 maps"),
            ("@\na=b\nb=a\nA=a*A", "Line 2: Names or brackets go on"),
            ("@@import x.aifs", "Line 1: Other files are not fetched."),
            ("@\nh=1", "Line 1: No block has an equation"),
            ("@\nA=2^9999*A", "Line 2: A number becomes too large."),
        ] {
            assert!(told(text).starts_with(start), "{text}: {}", told(text));
            assert!(told(text).ends_with(SUBSET));
        }
    }
}
