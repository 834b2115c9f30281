//! Meshes in the GLB format: binary glTF 2.0.

use cspace::PatchId;
use serde_json::{Value, json};

use super::mesh::Mesh;

/// The attribute of a vertex with the number of the patch it lies on.
pub const PATCH_ATTRIBUTE: &str = "_PATCH";

/// Component types of glTF 2.0, section 3.6.2.2.
const UNSIGNED_BYTE: u32 = 5121;
const UNSIGNED_INT: u32 = 5125;
const FLOAT: u32 = 5126;
/// Targets of buffer views, section 3.6.1.
const ARRAY_BUFFER: u32 = 34962;
const ELEMENT_ARRAY_BUFFER: u32 = 34963;
/// Number of patches from which on a number is not exact as an `f32`: attributes of applications may not be integers of
/// four bytes.
const TOO_MANY_PATCHES: u32 = 1 << 24;

/// Name of the only node.
const NODE: &str = "contact surface";

/// Why a mesh has no GLB file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum GlbError {
    /// A coordinate is not finite in single precision.
    #[error("a coordinate is beyond single precision, which is all that the format has")]
    Coordinate,
    /// Lengths are stored in four bytes.
    #[error("the mesh is larger than the 4 GiB that the format can hold")]
    Size,
    /// Patches are numbered in single precision.
    #[error("there are more than 2^24 patches, the numbers that single precision tells apart")]
    Patches,
}

/// The vertices of the file: one for each vertex of the mesh and each patch it is used by.
struct Arrays {
    positions: Vec<[f32; 3]>,
    /// Unit vectors towards free space, of each patch for itself.
    normals: Vec<[f32; 3]>,
    patches: Vec<u32>,
    indices: Vec<u32>,
    /// Description of the coordinates.
    coordinates: String,
}

/// Colours of patches, used in turn: those of Okabe and Ito, which the colour-blind can distinguish, without black.
const COLORS: [[u8; 4]; 7] = [
    [230, 159, 0, 255],
    [86, 180, 233, 255],
    [0, 158, 115, 255],
    [240, 228, 66, 255],
    [0, 114, 178, 255],
    [213, 94, 0, 255],
    [204, 121, 167, 255],
];

/// The mesh as a binary glTF 2.0 file: vertices (x, y, θ) in single precision, which is all the format has; triangles
/// counter-clockwise seen from free space.
///
/// The attribute [`PATCH_ATTRIBUTE`] of the vertices, a float, is the number of the patch. The three vertices of a triangle
/// have the same: where patches meet, the surface has a vertex for each, of one position to the last bit. The model's x, y
/// and scaled θ are the format's X, Y and Z; no node turns them. Normals are those of the triangles around, each patch for itself,
/// and patches have colours.
///
/// Triangles of which two corners are one place in single precision are left out, which opens no edge.
///
/// ```
/// use cspace::{ContactSpace, Options, Part, Vertex};
/// use cspace_model::write::glb::glb;
/// use cspace_model::write::mesh::{Mesh, MeshOptions};
/// let square = |name: &str, r: f64| {
///     let corners = [(-r, -r), (r, -r), (r, r), (-r, r)];
///     Part::new(name, vec![corners.iter().map(|&(x, y)| Vertex::line(x, y)).collect()])
/// };
/// let space = ContactSpace::compute(&square("table", 2.0)?, &square("block", 1.0)?, &Options::default())?;
/// let bytes = glb(&Mesh::new(&space, &MeshOptions { tolerance: 0.01 })?)?;
/// assert_eq!(&bytes[..8], b"glTF\x02\0\0\0");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// If a coordinate is beyond single precision, or there are more patches or bytes than the format can number.
pub fn glb(mesh: &Mesh) -> Result<Vec<u8>, GlbError> {
    let arrays = Arrays::new(mesh)?;
    let binary = arrays.binary();
    let mut json = arrays.description(binary.len()).to_string().into_bytes();
    // Chunks are padded to four bytes: text with spaces (section 4.4.3.2). All numbers have four.
    json.resize(json.len().next_multiple_of(4), b' ');
    let chunk = |length: usize| if length > 0 { 8 + length } else { 0 };
    let total = 12 + chunk(json.len()) + chunk(binary.len());
    let length = |n: usize| u32::try_from(n).map_err(|_| GlbError::Size);
    let mut out = Vec::with_capacity(total);
    out.extend_from_slice(b"glTF");
    for word in [2, length(total)?] {
        out.extend_from_slice(&word.to_le_bytes());
    }
    for (kind, bytes) in [(b"JSON", json), (b"BIN\0", binary)] {
        if !bytes.is_empty() {
            out.extend_from_slice(&length(bytes.len())?.to_le_bytes());
            out.extend_from_slice(kind);
            out.extend_from_slice(&bytes);
        }
    }
    Ok(out)
}

impl Arrays {
    fn new(mesh: &Mesh) -> Result<Self, GlbError> {
        if !mesh.fits_single_precision() {
            return Err(GlbError::Coordinate);
        }
        // A sum of 0 and −0 is 0: the two are one place, and one pattern of bits.
        let single = |x: f64| x as f32 + 0.0;
        let places: Vec<[f32; 3]> = mesh.places().map(|p| p.map(single)).collect();
        let mut triangles: Vec<_> = (mesh.triangles.iter())
            .filter(|t| {
                let [a, b, c] = t.vertices.map(|v| places[v as usize]);
                a != b && b != c && c != a
            })
            .collect();
        // Patch by patch, in the order of the mesh within each.
        triangles.sort_by_key(|t| t.patch);
        let mut arrays = Self {
            positions: Vec::new(),
            normals: Vec::new(),
            patches: Vec::new(),
            indices: Vec::with_capacity(3 * triangles.len()),
            coordinates: mesh.coordinates(),
        };
        // The vertex of the file that a vertex of the mesh had last, and for which patch.
        let mut last: Vec<Option<(PatchId, u32)>> = vec![None; places.len()];
        for t in triangles {
            if t.patch.0 >= TOO_MANY_PATCHES {
                return Err(GlbError::Patches);
            }
            for v in t.vertices {
                let slot = &mut last[v as usize];
                let index = match *slot {
                    Some((patch, index)) if patch == t.patch => index,
                    _ => {
                        // The largest index is reserved (section 3.7.2.1).
                        let index = u32::try_from(arrays.positions.len())
                            .ok()
                            .filter(|&i| i < u32::MAX)
                            .ok_or(GlbError::Size)?;
                        arrays.positions.push(places[v as usize]);
                        arrays.patches.push(t.patch.0);
                        *slot = Some((t.patch, index));
                        index
                    }
                };
                arrays.indices.push(index);
            }
        }
        arrays.normals = arrays.normals_of_triangles();
        Ok(arrays)
    }

    /// Normal at each vertex: the direction of the sum of its triangles' normals, weighted by area.
    fn normals_of_triangles(&self) -> Vec<[f32; 3]> {
        let mut sums = vec![[0.0_f64; 3]; self.positions.len()];
        for t in self.indices.chunks_exact(3) {
            let [a, b, c] = [t[0], t[1], t[2]].map(|i| self.positions[i as usize].map(f64::from));
            let (u, v) = (
                [0, 1, 2].map(|k| b[k] - a[k]),
                [0, 1, 2].map(|k| c[k] - a[k]),
            );
            let n = [
                u[1] * v[2] - u[2] * v[1],
                u[2] * v[0] - u[0] * v[2],
                u[0] * v[1] - u[1] * v[0],
            ];
            for &i in t {
                for (sum, x) in sums[i as usize].iter_mut().zip(n) {
                    *sum += x;
                }
            }
        }
        let unit = |n: [f64; 3]| {
            let length = n.iter().map(|x| x * x).sum::<f64>().sqrt();
            // Normals must have length 1 (section 3.7.2.1), also where triangles are too narrow to have any.
            if length > 0.0 && length.is_finite() {
                n.map(|x| (x / length) as f32)
            } else {
                [0.0, 0.0, 1.0]
            }
        };
        sums.into_iter().map(unit).collect()
    }

    /// Positions, patches, indices, normals and colours, one after the other.
    fn binary(&self) -> Vec<u8> {
        let mut out = Vec::with_capacity(32 * self.positions.len() + 4 * self.indices.len());
        for x in self.positions.iter().flatten() {
            out.extend_from_slice(&x.to_le_bytes());
        }
        for &patch in &self.patches {
            out.extend_from_slice(&(patch as f32).to_le_bytes());
        }
        for index in &self.indices {
            out.extend_from_slice(&index.to_le_bytes());
        }
        for x in self.normals.iter().flatten() {
            out.extend_from_slice(&x.to_le_bytes());
        }
        for &patch in &self.patches {
            out.extend_from_slice(&COLORS[patch as usize % COLORS.len()]);
        }
        out
    }

    /// Header of the file: describes the meaning of the bytes.
    fn description(&self, bytes: usize) -> Value {
        let asset = json!({ "version": "2.0", "generator": "cspace" });
        if self.indices.is_empty() {
            // Accessors, buffers and the scene's list of nodes may not be empty.
            return json!({
                "asset": asset,
                "scene": 0,
                "scenes": [{ "nodes": [0] }],
                "nodes": [{ "name": NODE }],
            });
        }
        let (n, indices) = (self.positions.len(), self.indices.len());
        let (lo, hi) = self.box_of_positions();
        json!({
            "asset": asset,
            "scene": 0,
            "scenes": [{ "nodes": [0] }],
            "nodes": [{ "mesh": 0, "name": NODE }],
            "meshes": [{
                "name": format!("contact surface: {}", self.coordinates),
                "primitives": [{
                    "attributes": { "POSITION": 0, PATCH_ATTRIBUTE: 1, "NORMAL": 3, "COLOR_0": 4 },
                    "indices": 2,
                    "material": 0,
                }],
            }],
            // The surface is visible from blocked space as well.
            "materials": [{
                "name": "contact",
                "doubleSided": true,
                "pbrMetallicRoughness": { "metallicFactor": 0.0, "roughnessFactor": 0.8 },
            }],
            "accessors": [
                { "bufferView": 0, "componentType": FLOAT, "count": n, "type": "VEC3", "min": lo, "max": hi },
                { "bufferView": 1, "componentType": FLOAT, "count": n, "type": "SCALAR" },
                { "bufferView": 2, "componentType": UNSIGNED_INT, "count": indices, "type": "SCALAR" },
                { "bufferView": 3, "componentType": FLOAT, "count": n, "type": "VEC3" },
                { "bufferView": 4, "componentType": UNSIGNED_BYTE, "normalized": true, "count": n, "type": "VEC4" },
            ],
            "bufferViews": [
                { "buffer": 0, "byteOffset": 0, "byteLength": 12 * n, "target": ARRAY_BUFFER },
                { "buffer": 0, "byteOffset": 12 * n, "byteLength": 4 * n, "target": ARRAY_BUFFER },
                { "buffer": 0, "byteOffset": 16 * n, "byteLength": 4 * indices, "target": ELEMENT_ARRAY_BUFFER },
                { "buffer": 0, "byteOffset": 16 * n + 4 * indices, "byteLength": 12 * n, "target": ARRAY_BUFFER },
                { "buffer": 0, "byteOffset": 28 * n + 4 * indices, "byteLength": 4 * n, "target": ARRAY_BUFFER },
            ],
            "buffers": [{ "byteLength": bytes }],
        })
    }

    fn box_of_positions(&self) -> ([f32; 3], [f32; 3]) {
        let along = |k: usize| self.positions.iter().map(move |p| p[k]);
        let least = |k| along(k).fold(f32::INFINITY, f32::min);
        let greatest = |k| along(k).fold(f32::NEG_INFINITY, f32::max);
        ([0, 1, 2].map(least), [0, 1, 2].map(greatest))
    }
}
