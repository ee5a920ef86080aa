//! A table, a map a line.

use crate::number::decimal;
use crate::system::{Maps, System};

pub fn write(system: &System) -> String {
    let heading = match system.maps {
        Maps::Plane(_) | Maps::Directed(_) => "a,b,c,d,e,f,p",
        Maps::Space(_) | Maps::Objects(_) => "a,b,c,d,e,f,g,h,i,x,y,z,p",
    };
    let mut text = format!("{heading}\n");
    for (row, weight) in system.maps.rows().into_iter().zip(system.weights()) {
        let words: Vec<String> = row.iter().chain([&weight]).map(|&x| decimal(x)).collect();
        text.push_str(&words.join(","));
        text.push('\n');
    }
    text
}
