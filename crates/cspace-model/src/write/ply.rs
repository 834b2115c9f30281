//! Meshes in the PLY format.

use std::fmt::Write;

use super::mesh::Mesh;

/// Encoding of numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Encoding {
    /// Binary numbers, little-endian.
    #[default]
    Binary,
    /// Text with all digits.
    Ascii,
}

/// The mesh as a PLY file: vertices with `x`, `y` and `z`, which is θ, as doubles; triangles with the `patch` they lie on.
pub fn ply(mesh: &Mesh, encoding: Encoding) -> Vec<u8> {
    let format = match encoding {
        Encoding::Binary => "binary_little_endian",
        Encoding::Ascii => "ascii",
    };
    let header = format!(
        "ply\nformat {format} 1.0\ncomment contact surface: {}\n\
         element vertex {}\nproperty double x\nproperty double y\nproperty double z\n\
         element face {}\nproperty list uchar int vertex_indices\nproperty int patch\nend_header\n",
        mesh.coordinates(),
        mesh.vertices.len(),
        mesh.triangles.len()
    );
    match encoding {
        Encoding::Binary => binary(header.into_bytes(), mesh),
        Encoding::Ascii => ascii(header, mesh).into_bytes(),
    }
}

fn binary(mut out: Vec<u8>, mesh: &Mesh) -> Vec<u8> {
    out.reserve(24 * mesh.vertices.len() + 17 * mesh.triangles.len());
    for x in mesh.places().flatten() {
        out.extend_from_slice(&x.to_le_bytes());
    }
    for t in &mesh.triangles {
        out.push(3);
        for v in t.vertices.into_iter().chain([t.patch.0]) {
            out.extend_from_slice(&v.to_le_bytes());
        }
    }
    out
}

fn ascii(mut out: String, mesh: &Mesh) -> String {
    for [x, y, z] in mesh.places() {
        let _ = writeln!(out, "{x} {y} {z}");
    }
    for t in &mesh.triangles {
        let [a, b, c] = t.vertices;
        let _ = writeln!(out, "3 {a} {b} {c} {}", t.patch);
    }
    out
}
