//! Binary glTF 2.0: one mesh with a colour at every vertex, in metres, y upwards, as glTF has it.

use super::super::Mesh;

const METRES: f32 = 1e-3;

/// The mesh as binary glTF. `colours` has one for each code, as on the screen.
#[must_use]
pub fn glb(mesh: &Mesh, colours: &[[u8; 3]]) -> Vec<u8> {
    // From z upwards to y upwards.
    let turned = |[x, y, z]: [f32; 3]| [x, z, -y];
    let places: Vec<[f32; 3]> = mesh.positions.iter().map(|&p| turned(p).map(|x| x * METRES)).collect();
    let (vertices, triangles) = (places.len(), mesh.triangles.len());
    let bound = |of: fn(f32, f32) -> f32| {
        let bound = places.iter().copied().reduce(|a, b| [0, 1, 2].map(|k| of(a[k], b[k])));
        let [x, y, z] = bound.unwrap_or_default();
        format!("[{x:?},{y:?},{z:?}]")
    };
    let (least, largest) = (bound(f32::min), bound(f32::max));
    let starts = [0, 12 * vertices, 24 * vertices, 28 * vertices];
    let length = starts[3] + 12 * triangles;
    let [_, normals, tints, indices] = starts;
    let (count, corners) = (12 * vertices, 3 * triangles);
    let mut json =
        String::from(r#"{"asset":{"version":"2.0","generator":"Frond"},"scene":0,"scenes":[{"nodes":[0]}],"#);
    json += r#""nodes":[{"mesh":0}],"#;
    json += r#""meshes":[{"primitives":[{"attributes":{"POSITION":0,"NORMAL":1,"COLOR_0":2},"indices":3,"material":0}]}],"#;
    json += r#""materials":[{"name":"Frond","pbrMetallicRoughness":{"metallicFactor":0,"roughnessFactor":0.7}}],"#;
    json += &format!(r#""buffers":[{{"byteLength":{length}}}],"bufferViews":["#);
    json += &format!(r#"{{"buffer":0,"byteOffset":0,"byteLength":{count},"target":34962}},"#);
    json += &format!(r#"{{"buffer":0,"byteOffset":{normals},"byteLength":{count},"target":34962}},"#);
    json += &format!(r#"{{"buffer":0,"byteOffset":{tints},"byteLength":{},"target":34962}},"#, 4 * vertices);
    json += &format!(
        r#"{{"buffer":0,"byteOffset":{indices},"byteLength":{},"target":34963}}],"accessors":["#,
        12 * triangles
    );
    json += &format!(
        r#"{{"bufferView":0,"componentType":5126,"count":{vertices},"type":"VEC3","min":{least},"max":{largest}}},"#
    );
    json += &format!(r#"{{"bufferView":1,"componentType":5126,"count":{vertices},"type":"VEC3"}},"#);
    json += &format!(
        r#"{{"bufferView":2,"componentType":5121,"normalized":true,"count":{vertices},"type":"VEC4"}},"#
    );
    json += &format!(r#"{{"bufferView":3,"componentType":5125,"count":{corners},"type":"SCALAR"}}]}}"#);
    json += &" ".repeat(json.len().next_multiple_of(4) - json.len());

    let whole = 12 + 8 + json.len() + 8 + length;
    let mut bytes = Vec::with_capacity(whole);
    let word = |bytes: &mut Vec<u8>, value: usize| bytes.extend((value as u32).to_le_bytes());
    bytes.extend(b"glTF");
    word(&mut bytes, 2);
    word(&mut bytes, whole);
    word(&mut bytes, json.len());
    bytes.extend(b"JSON");
    bytes.extend(json.as_bytes());
    word(&mut bytes, length);
    bytes.extend(b"BIN\0");
    bytes.extend(places.iter().flatten().flat_map(|x| x.to_le_bytes()));
    bytes.extend(mesh.normals.iter().flat_map(|&n| turned(n)).flat_map(f32::to_le_bytes));
    let linear: Vec<[u8; 4]> = colours.iter().map(|&[r, g, b]| [light(r), light(g), light(b), 255]).collect();
    bytes.extend(mesh.codes.iter().flat_map(|&code| *linear.get(usize::from(code)).unwrap_or(&[255; 4])));
    bytes.extend(mesh.triangles.iter().flatten().flat_map(|v| v.to_le_bytes()));
    bytes
}

/// A channel of the screen (sRGB) as light: glTF's colours of vertices are linear.
fn light(channel: u8) -> u8 {
    let c = f32::from(channel) / 255.0;
    let linear = if c <= 0.04045 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) };
    (linear * 255.0).round() as u8
}

#[cfg(test)]
mod tests {
    use super::super::testing::{Reader, tetrahedron};
    use super::*;

    #[test]
    fn the_chunks_are_as_long_as_they_say_and_the_numbers_come_back() {
        let mesh = tetrahedron();
        let bytes = glb(&mesh, &[[255, 0, 0], [0, 188, 0]]);
        let mut file = Reader(&bytes);
        assert_eq!((file.take(), file.u32(), file.u32()), (*b"glTF", 2, bytes.len() as u32));
        let length = file.u32() as usize;
        assert_eq!((file.take(), length % 4), (*b"JSON", 0));
        let (json, rest) = file.0.split_at(length);
        let json = str::from_utf8(json).unwrap();
        assert!(json.contains(r#""min":[0.0,0.0,-0.003],"max":[0.003,0.003,-0.0]"#), "{json}");
        file.0 = rest;
        let length = file.u32() as usize;
        assert_eq!(file.take(), *b"BIN\0");
        assert_eq!(length, file.0.len());
        assert!(json.contains(&format!(r#""buffers":[{{"byteLength":{length}}}]"#)));
        for [x, y, z] in &mesh.positions {
            let [fx, fy, fz] = [(); 3].map(|()| file.f32());
            for (a, b) in [(fx, x * METRES), (fy, z * METRES), (fz, -y * METRES)] {
                assert!((a - b).abs() < 1e-9);
            }
        }
        for &[x, y, z] in &mesh.normals {
            assert_eq!([(); 3].map(|()| file.f32()), [x, z, -y]);
        }
        let colours = [(); 4].map(|()| file.take::<4>());
        // The third code has no colour.
        assert_eq!(colours, [[255, 0, 0, 255], [0, 128, 0, 255], [255; 4], [255, 0, 0, 255]]);
        for &triangle in &mesh.triangles {
            assert_eq!([(); 3].map(|()| file.u32()), triangle);
        }
        assert!(file.0.is_empty());
    }
}
