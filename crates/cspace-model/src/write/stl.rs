//! Meshes in the STL format.

use std::fmt::Write;

use super::mesh::Mesh;
use super::ply::Encoding;

/// Writes the mesh as an STL file: triangles with coordinates (x, y, θ) in single precision, which is all the format
/// has.
///
/// Triangles with two corners that are equal in single precision are left out. This opens no edge, because the
/// remaining edges of such a triangle coincide in opposite directions.
///
/// ```
/// use cspace::{ContactSpace, Options, Part, Vertex};
/// use cspace_model::write::mesh::{Mesh, MeshOptions};
/// use cspace_model::write::{ply::Encoding, stl::stl};
/// let square = |name: &str, r: f64| {
///     let corners = [(-r, -r), (r, -r), (r, r), (-r, r)];
///     Part::new(name, vec![corners.iter().map(|&(x, y)| Vertex::line(x, y)).collect()])
/// };
/// let space = ContactSpace::compute(&square("table", 2.0)?, &square("block", 1.0)?, &Options::default())?;
/// let mesh = Mesh::new(&space, &MeshOptions { tolerance: 0.01 })?;
/// let bytes = stl(&mesh, Encoding::Binary);
/// let count = u32::from_le_bytes([bytes[80], bytes[81], bytes[82], bytes[83]]);
/// assert_eq!(bytes.len(), 84 + 50 * count as usize);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn stl(mesh: &Mesh, encoding: Encoding) -> Vec<u8> {
    let triangles: Vec<[[f32; 3]; 3]> = (mesh.triangles.iter())
        .map(|t| t.vertices.map(|v| mesh.place(v).map(|x| x as f32)))
        .filter(|[a, b, c]| a != b && b != c && c != a)
        .collect();
    match encoding {
        Encoding::Binary => binary(
            &format!("contact surface: {}", mesh.coordinates()),
            &triangles,
        ),
        Encoding::Ascii => ascii(&triangles).into_bytes(),
    }
}

fn binary(header: &str, triangles: &[[[f32; 3]; 3]]) -> Vec<u8> {
    let mut out = Vec::with_capacity(84 + 50 * triangles.len());
    // Readers take a header that begins with `solid` for the text format.
    out.extend_from_slice(&header.as_bytes()[..header.len().min(80)]);
    out.resize(80, b' ');
    out.extend_from_slice(&(triangles.len() as u32).to_le_bytes());
    for t in triangles {
        for x in [normal(t)].iter().chain(t).flatten() {
            out.extend_from_slice(&x.to_le_bytes());
        }
        out.extend_from_slice(&[0, 0]);
    }
    out
}

fn ascii(triangles: &[[[f32; 3]; 3]]) -> String {
    let mut out = String::from("solid contact_surface\n");
    for t in triangles {
        let [x, y, z] = normal(t);
        let _ = writeln!(out, "facet normal {x:e} {y:e} {z:e}\nouter loop");
        for [x, y, z] in t {
            let _ = writeln!(out, "vertex {x:e} {y:e} {z:e}");
        }
        out.push_str("endloop\nendfacet\n");
    }
    out.push_str("endsolid contact_surface\n");
    out
}

/// The unit normal, towards free space; zero for a triangle without area.
fn normal([a, b, c]: &[[f32; 3]; 3]) -> [f32; 3] {
    let from_a = |p: &[f32; 3]| [0, 1, 2].map(|k| f64::from(p[k]) - f64::from(a[k]));
    let (u, v) = (from_a(b), from_a(c));
    let n = [
        u[1] * v[2] - u[2] * v[1],
        u[2] * v[0] - u[0] * v[2],
        u[0] * v[1] - u[1] * v[0],
    ];
    let length = n.iter().map(|x| x * x).sum::<f64>().sqrt();
    if length > 0.0 && length.is_finite() {
        n.map(|x| (x / length) as f32)
    } else {
        [0.0; 3]
    }
}
