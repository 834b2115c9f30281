//! Binary glTF, read back by the words of the standard (glTF 2.0, sections 3.6 and 4). Other programs' readers open it in
//! `crates/cspace-cli/tests/meshes.py`.

use std::collections::BTreeMap;

use cspace::{ContactSpace, Options, PatchId};
use cspace_model::model;
use cspace_model::write::glb::{GlbError, PATCH_ATTRIBUTE, glb};
use cspace_model::write::mesh::{Mesh, MeshOptions};
use serde_json::Value;

type Place = [f32; 3];

/// Content of a file: the corners of each triangle with the patch that each of them names.
struct Read {
    triangles: Vec<[(Place, f32); 3]>,
    vertices: usize,
}

/// The two chunks of a file.
struct File {
    json: Value,
    blob: Option<Vec<u8>>,
}

impl File {
    fn new(bytes: &[u8]) -> Self {
        let word = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap()) as usize;
        assert_eq!(
            (&bytes[..4], word(4), word(8)),
            (&b"glTF"[..], 2, bytes.len())
        );
        let end = 20 + word(12);
        assert_eq!(&bytes[16..20], b"JSON");
        let json: Value = serde_json::from_slice(&bytes[20..end]).unwrap();
        assert_eq!(json["asset"]["version"], "2.0");
        let blob = (end < bytes.len()).then(|| {
            assert_eq!(&bytes[end + 4..end + 8], b"BIN\0");
            bytes[end + 8..end + 8 + word(end)].to_vec()
        });
        Self { json, blob }
    }

    fn primitive(&self) -> &Value {
        let primitives = self.json["meshes"][0]["primitives"].as_array().unwrap();
        assert_eq!(primitives.len(), 1);
        &primitives[0]
    }

    /// Bytes of the items of an accessor, which has a type and a type of component, and lies within its view, buffer and file.
    fn items(&self, accessor: &Value, kind: &str, component: u64) -> Vec<&[u8]> {
        let number = |v: &Value| v.as_u64().unwrap_or(0) as usize;
        let accessor = &self.json["accessors"][number(accessor)];
        assert_eq!(
            (&accessor["type"], &accessor["componentType"]),
            (&kind.into(), &component.into())
        );
        let view = &self.json["bufferViews"][number(&accessor["bufferView"])];
        let numbers = match kind {
            "SCALAR" => 1,
            "VEC3" => 3,
            "VEC4" => 4,
            _ => unreachable!("{kind}"),
        };
        let size = numbers * if component == UNSIGNED_BYTE { 1 } else { 4 };
        let stride = view["byteStride"].as_u64().map_or(size, |s| s as usize);
        let from = number(&view["byteOffset"]) + number(&accessor["byteOffset"]);
        let count = number(&accessor["count"]);
        let view_end = number(&view["byteOffset"]) + number(&view["byteLength"]);
        assert!(from + stride * (count - 1) + size <= view_end);
        assert!(from.is_multiple_of(4) && stride.is_multiple_of(4));
        assert!(view_end <= number(&self.json["buffers"][number(&view["buffer"])]["byteLength"]));
        let blob = self.blob.as_deref().unwrap();
        (0..count)
            .map(|i| &blob[from + stride * i..][..size])
            .collect()
    }

    fn floats<const N: usize>(&self, name: &str, kind: &str) -> Vec<[f32; N]> {
        let accessor = &self.primitive()["attributes"][name];
        assert!(accessor.is_u64(), "{name}");
        let float =
            |item: &[u8], k: usize| f32::from_le_bytes(item[4 * k..4 * k + 4].try_into().unwrap());
        let items = self.items(accessor, kind, FLOAT).into_iter();
        items
            .map(|item| core::array::from_fn(|k| float(item, k)))
            .collect()
    }

    fn places(&self) -> Vec<Place> {
        self.floats("POSITION", "VEC3")
    }

    fn normals(&self) -> Vec<Place> {
        self.floats("NORMAL", "VEC3")
    }

    fn patches(&self) -> Vec<f32> {
        let patches = self.floats::<1>(PATCH_ATTRIBUTE, "SCALAR");
        patches.into_iter().map(|[p]| p).collect()
    }
}

/// Types of components, by their numbers in the standard.
const UNSIGNED_BYTE: u64 = 5121;
const UNSIGNED_INT: u64 = 5125;
const FLOAT: u64 = 5126;
/// Mode of a primitive, by its number in the standard.
const TRIANGLES: u64 = 4;

fn read(bytes: &[u8]) -> Read {
    let file = File::new(bytes);
    let buffers = file.json["buffers"].as_array().unwrap();
    let length = file.blob.as_ref().unwrap().len();
    assert_eq!(
        (buffers.len(), &buffers[0]["byteLength"]),
        (1, &length.into())
    );
    let nodes = file.json["scenes"][0]["nodes"].as_array().unwrap();
    assert_eq!((nodes.len(), &file.json["scene"]), (1, &0.into()));
    // Coordinates are the surface's own: a node without these has the identity.
    let node = &file.json["nodes"][0];
    for key in ["matrix", "translation", "rotation", "scale"] {
        assert!(node[key].is_null(), "{key}");
    }
    assert_eq!(node["mesh"], 0);
    let primitive = file.primitive();
    assert_eq!(primitive["mode"].as_u64().unwrap_or(TRIANGLES), TRIANGLES);
    let places = file.places();
    let indices = file.items(&primitive["indices"], "SCALAR", UNSIGNED_INT);
    let indices: Vec<u32> = (indices.into_iter())
        .map(|i| u32::from_le_bytes(i.try_into().unwrap()))
        .collect();
    let patches = file.patches();
    assert_eq!(patches.len(), places.len());
    let normals = file.normals();
    let unit = |n: &Place| (n.iter().map(|x| x * x).sum::<f32>() - 1.0).abs() < 1e-5;
    assert!(normals.len() == places.len() && normals.iter().all(unit));
    let colors = file.items(&primitive["attributes"]["COLOR_0"], "VEC4", UNSIGNED_BYTE);
    let same_color = |i: usize, j: usize| patches[i] != patches[j] || colors[i] == colors[j];
    assert!(colors.len() == places.len() && (1..places.len()).all(|i| same_color(i - 1, i)));
    // The box that the format wants is that of the places.
    let accessor = primitive["attributes"]["POSITION"].as_u64().unwrap() as usize;
    let bound =
        |name: &str, k: usize| file.json["accessors"][accessor][name][k].as_f64().unwrap() as f32;
    for k in 0..3 {
        let along = || places.iter().map(|p| p[k]);
        assert_eq!(bound("min", k), along().fold(f32::INFINITY, f32::min));
        assert_eq!(bound("max", k), along().fold(f32::NEG_INFINITY, f32::max));
    }
    let corner = |i: u32| (places[i as usize], patches[i as usize]);
    Read {
        triangles: indices
            .chunks(3)
            .map(|t| [corner(t[0]), corner(t[1]), corner(t[2])])
            .collect(),
        vertices: places.len(),
    }
}

fn mesh(model: &str, window: Option<(f64, f64)>) -> Mesh {
    let path = format!("{}/../../models/{model}.toml", env!("CARGO_MANIFEST_DIR"));
    let model = model::read(path).unwrap();
    let pair = &model.pairs[0];
    let part = |i: usize| &model.parts[i].part;
    let options = Options {
        window: window.or(pair.window),
        ..Options::default()
    };
    let space = ContactSpace::compute(part(pair.fixed), part(pair.moving), &options).unwrap();
    Mesh::new(&space, &MeshOptions { tolerance: 0.005 }).unwrap()
}

/// Every triangle is there, with its patch and turned as it was, but those that single precision makes flat; and what the
/// mesh closes the file closes.
fn check(name: &str, mesh: &Mesh) {
    let found = read(&glb(mesh).unwrap());
    let place = |v: u32| {
        let v = mesh.vertices[v as usize];
        [v.x, v.y, v.theta].map(|x| x as f32 + 0.0)
    };
    let key = |t: [(Place, f32); 3]| {
        let [(_, patch), ..] = t;
        assert!(
            t.iter().all(|c| c.1 == patch),
            "{name}: one patch for each triangle"
        );
        // From whichever corner, but the same way around.
        let bits = t.map(|(p, _)| p.map(f32::to_bits));
        let least = (0..3).min_by_key(|&k| bits[k]).unwrap();
        ([0, 1, 2].map(|k| bits[(least + k) % 3]), patch as u32)
    };
    let mut wanted: Vec<_> = (mesh.triangles.iter())
        .map(|t| t.vertices.map(|v| (place(v), t.patch.0 as f32)))
        .filter(|[a, b, c]| a.0 != b.0 && b.0 != c.0 && c.0 != a.0)
        .map(key)
        .collect();
    let mut given: Vec<_> = found.triangles.iter().copied().map(key).collect();
    wanted.sort_unstable();
    given.sort_unstable();
    assert!(wanted == given, "{name}");
    assert!(given.len() * 10 > mesh.triangles.len() * 9, "{name}");
    // No more vertices than corners, and shared within a patch.
    assert!(
        found.vertices < 2 * given.len(),
        "{name}: {}",
        found.vertices
    );
    let mut edges: BTreeMap<_, i32> = BTreeMap::new();
    for (corners, _) in given {
        for k in 0..3 {
            let (a, b) = (corners[k], corners[(k + 1) % 3]);
            *edges.entry((a.min(b), a.max(b))).or_default() += if a < b { 1 } else { -1 };
        }
    }
    let ends = [mesh.ends.0, mesh.ends.1].map(|t| (t as f32).to_bits());
    let open = |((a, b), sum): &(&([u32; 3], [u32; 3]), &i32)| {
        **sum != 0 && !ends.iter().any(|&end| a[2] == end && b[2] == end)
    };
    assert_eq!(edges.iter().filter(open).count(), 0, "{name}");
    assert!(
        edges.values().any(|&sum| sum != 0),
        "{name}: cut at its ends"
    );
}

#[test]
fn files_have_the_triangles_of_the_mesh_and_are_closed() {
    for model in [
        "ball_in_c",
        "knee",
        "peg_hole",
        "ratchet_pawl",
        "snap_fastener",
    ] {
        check(model, &mesh(model, None));
    }
    check("window", &mesh("peg_hole", Some((-0.3, 2.0))));
}

#[test]
fn chunks_are_whole_and_padded() {
    let bytes = glb(&mesh("ball_in_c", None)).unwrap();
    let word = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap()) as usize;
    assert_eq!(
        (&bytes[..4], word(4), word(8)),
        (&b"glTF"[..], 2, bytes.len())
    );
    let json = word(12);
    assert_eq!((&bytes[16..20], json % 4), (&b"JSON"[..], 0));
    let text = std::str::from_utf8(&bytes[20..20 + json]).unwrap();
    serde_json::from_str::<Value>(text).unwrap();
    let at = 20 + json;
    assert_eq!((&bytes[at + 4..at + 8], word(at) % 4), (&b"BIN\0"[..], 0));
    assert_eq!(at + 8 + word(at), bytes.len());
}

#[test]
fn an_empty_mesh_is_an_empty_scene() {
    let bytes = glb(&Mesh::default()).unwrap();
    let File { json, blob } = File::new(&bytes);
    assert_eq!(json["scenes"][0]["nodes"].as_array().unwrap().len(), 1);
    assert!(json["nodes"][0]["mesh"].is_null() && blob.is_none());
}

#[test]
fn what_single_precision_cannot_hold_is_refused() {
    let good = mesh("ball_in_c", None);
    let mut far = good.clone();
    far.vertices[3].x = 1e39;
    assert_eq!(glb(&far), Err(GlbError::Coordinate));
    let mut many = good;
    many.triangles[0].patch = PatchId(1 << 24);
    assert_eq!(glb(&many), Err(GlbError::Patches));
}

/// Normals point to free space: they are the contact functions' gradients, in the scaled coordinates.
#[test]
fn normals_are_those_of_the_surface() {
    let mesh = mesh("peg_hole", None);
    let mesh = mesh.clone().with_theta_scale(mesh.turn_as_tall_as_wide());
    let (lo, hi) = (mesh.vertices.iter()).fold((f64::MAX, f64::MIN), |(lo, hi), v| {
        (lo.min(v.x.min(v.y)), hi.max(v.x.max(v.y)))
    });
    let turn = mesh.theta_scale * core::f64::consts::TAU;
    assert!(
        turn <= (hi - lo) * (1.0 + 1e-12) && turn > 0.3 * (hi - lo),
        "{turn}"
    );
    let bytes = glb(&mesh).unwrap();
    let file = File::new(&bytes);
    let (places, normals) = (file.places(), file.normals());
    let path = format!("{}/../../models/peg_hole.toml", env!("CARGO_MANIFEST_DIR"));
    let model = model::read(path).unwrap();
    let [fixed, moving] = [model.pairs[0].fixed, model.pairs[0].moving];
    let (fixed, moving) = (&model.parts[fixed].part, &model.parts[moving].part);
    let space = ContactSpace::compute(fixed, moving, &Options::default()).unwrap();
    let mut agree = 0;
    for ((p, n), patch) in places.iter().zip(&normals).zip(file.patches()) {
        let theta = f64::from(p[2]) / mesh.theta_scale;
        let c = cspace::Configuration::new(f64::from(p[0]), f64::from(p[1]), theta);
        let g = space.patch(PatchId(patch as u32)).unwrap().gradient(c);
        let g = [g[0], g[1], g[2] / mesh.theta_scale];
        let length = g.iter().map(|x| x * x).sum::<f64>().sqrt();
        let dot: f64 = g.iter().zip(n).map(|(g, n)| g * f64::from(*n)).sum();
        agree += usize::from(dot > 0.8 * length);
    }
    // But at a few vertices between patches, where triangles are narrow.
    assert!(
        agree * 100 > normals.len() * 97,
        "{agree} of {}",
        normals.len()
    );
}
