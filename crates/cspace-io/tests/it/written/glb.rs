//! Binary glTF, read back by another program's reader.

use std::collections::BTreeMap;

use cspace::{ContactSpace, Options};
use cspace_io::model;
use cspace_io::write::glb::{GlbError, PATCH_ATTRIBUTE, glb};
use cspace_io::write::mesh::{Mesh, MeshOptions};
use gltf::Semantic;
use gltf::accessor::{DataType, Dimensions};
use gltf::mesh::Mode;

type Place = [f32; 3];

/// Content of a file: the corners of each triangle with the patch that each of them names.
struct Read {
    triangles: Vec<[(Place, f32); 3]>,
    vertices: usize,
}

fn read(bytes: &[u8]) -> Read {
    // Validates indices, accessors, views and what is required.
    let file = gltf::Gltf::from_slice(bytes).unwrap();
    let blob = file.blob.as_deref().unwrap();
    assert_eq!(
        file.buffers().map(|b| b.length()).collect::<Vec<_>>(),
        [blob.len()]
    );
    let nodes: Vec<_> = file.default_scene().unwrap().nodes().collect();
    assert_eq!(nodes.len(), 1);
    // Coordinates are the surface's own.
    let identity = [
        [1., 0., 0., 0.],
        [0., 1., 0., 0.],
        [0., 0., 1., 0.],
        [0., 0., 0., 1.],
    ];
    assert_eq!(nodes[0].transform().matrix(), identity);
    let primitives: Vec<_> = nodes[0].mesh().unwrap().primitives().collect();
    let [primitive] = &primitives[..] else {
        unreachable!("one primitive");
    };
    assert_eq!(primitive.mode(), Mode::Triangles);
    let reader = primitive.reader(|_| Some(blob));
    let places: Vec<Place> = reader.read_positions().unwrap().collect();
    let indices: Vec<u32> = reader.read_indices().unwrap().into_u32().collect();
    let patch = Semantic::Extras(PATCH_ATTRIBUTE.trim_start_matches('_').to_owned());
    let patch = primitive.get(&patch).unwrap();
    assert_eq!(
        (patch.data_type(), patch.dimensions()),
        (DataType::F32, Dimensions::Scalar)
    );
    let patches: Vec<f32> = gltf::accessor::Iter::new(patch, |_| Some(blob))
        .unwrap()
        .collect();
    assert_eq!(patches.len(), places.len());
    let normals: Vec<[f32; 3]> = reader.read_normals().unwrap().collect();
    let unit = |n: &[f32; 3]| (n.iter().map(|x| x * x).sum::<f32>() - 1.0).abs() < 1e-5;
    assert!(normals.len() == places.len() && normals.iter().all(unit));
    let colors: Vec<[u8; 4]> = reader.read_colors(0).unwrap().into_rgba_u8().collect();
    let same_color = |i: usize, j: usize| patches[i] != patches[j] || colors[i] == colors[j];
    assert!(colors.len() == places.len() && (1..places.len()).all(|i| same_color(i - 1, i)));
    // The box that the format wants is that of the places.
    let bounds = primitive.bounding_box();
    for k in 0..3 {
        let along = || places.iter().map(|p| p[k]);
        assert_eq!(bounds.min[k], along().fold(f32::INFINITY, f32::min));
        assert_eq!(bounds.max[k], along().fold(f32::NEG_INFINITY, f32::max));
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
        .map(|t| t.vertices.map(|v| (place(v), t.patch as f32)))
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
    serde_json::from_str::<serde_json::Value>(text).unwrap();
    let at = 20 + json;
    assert_eq!((&bytes[at + 4..at + 8], word(at) % 4), (&b"BIN\0"[..], 0));
    assert_eq!(at + 8 + word(at), bytes.len());
}

#[test]
fn an_empty_mesh_is_an_empty_scene() {
    let bytes = glb(&Mesh::default()).unwrap();
    let file = gltf::Gltf::from_slice(&bytes).unwrap();
    let nodes: Vec<_> = file.default_scene().unwrap().nodes().collect();
    assert!(nodes.len() == 1 && nodes[0].mesh().is_none());
    assert!(file.blob.is_none());
}

#[test]
fn what_single_precision_cannot_hold_is_refused() {
    let good = mesh("ball_in_c", None);
    let mut far = good.clone();
    far.vertices[3].x = 1e39;
    assert_eq!(glb(&far), Err(GlbError::Coordinate));
    let mut many = good;
    many.triangles[0].patch = 1 << 24;
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
    let file = gltf::Gltf::from_slice(&bytes).unwrap();
    let blob = file.blob.as_deref().unwrap();
    let primitive = (file.meshes().next().unwrap().primitives().next()).unwrap();
    let reader = primitive.reader(|_| Some(blob));
    let places: Vec<[f32; 3]> = reader.read_positions().unwrap().collect();
    let normals: Vec<[f32; 3]> = reader.read_normals().unwrap().collect();
    let path = format!("{}/../../models/peg_hole.toml", env!("CARGO_MANIFEST_DIR"));
    let model = model::read(path).unwrap();
    let [fixed, moving] = [model.pairs[0].fixed, model.pairs[0].moving];
    let (fixed, moving) = (&model.parts[fixed].part, &model.parts[moving].part);
    let space = ContactSpace::compute(fixed, moving, &Options::default()).unwrap();
    let patch = Semantic::Extras(PATCH_ATTRIBUTE.trim_start_matches('_').to_owned());
    let patches = gltf::accessor::Iter::<f32>::new(primitive.get(&patch).unwrap(), |_| Some(blob));
    let mut agree = 0;
    for ((p, n), patch) in places.iter().zip(&normals).zip(patches.unwrap()) {
        let theta = f64::from(p[2]) / mesh.theta_scale;
        let c = cspace::Configuration::new(f64::from(p[0]), f64::from(p[1]), theta);
        let g = space.patch(patch as u32).unwrap().gradient(c);
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
