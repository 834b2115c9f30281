//! Meshes in the OBJ format.

use std::fmt::Write;

use super::mesh::{Mesh, Triangle};

/// The mesh as an OBJ file: vertices (x, y, θ) with all their digits, the triangles of each patch in a group of its own.
///
/// ```
/// use cspace::{ContactSpace, Options, Part, Vertex};
/// use cspace_model::write::mesh::{Mesh, MeshOptions};
/// use cspace_model::write::obj::obj;
/// let square = |name: &str, r: f64| {
///     let corners = [(-r, -r), (r, -r), (r, r), (-r, r)];
///     Part::new(name, vec![corners.iter().map(|&(x, y)| Vertex::line(x, y)).collect()])
/// };
/// let space = ContactSpace::compute(&square("table", 2.0)?, &square("block", 1.0)?, &Options::default())?;
/// let mesh = Mesh::new(&space, &MeshOptions { tolerance: 0.01 })?;
/// let text = obj(&mesh);
/// assert_eq!(text.lines().filter(|l| l.starts_with("v ")).count(), mesh.vertices.len());
/// assert_eq!(text.lines().filter(|l| l.starts_with("f ")).count(), mesh.triangles.len());
/// assert!(text.contains("\ng patch_0\n"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn obj(mesh: &Mesh) -> String {
    let mut out = format!("# contact surface: {}\n", mesh.coordinates());
    for [x, y, z] in mesh.places() {
        let _ = writeln!(out, "v {x} {y} {z}");
    }
    let mut triangles: Vec<&Triangle> = mesh.triangles.iter().collect();
    triangles.sort_by_key(|t| t.patch);
    let mut patch = None;
    for t in triangles {
        if patch != Some(t.patch) {
            patch = Some(t.patch);
            let _ = writeln!(out, "g patch_{}", t.patch);
        }
        // Vertices are counted from 1.
        let [a, b, c] = t.vertices.map(|v| u64::from(v) + 1);
        let _ = writeln!(out, "f {a} {b} {c}");
    }
    out
}
