use cspace_motion::*;
#[test]
fn go() {
    let cspace_io::Document::Model(model) =
        cspace_io::read(std::path::Path::new("/tmp/mm/woodpecker.toml")).unwrap()
    else {
        panic!()
    };
    let sim = Simulation::new(&model).unwrap();
    let mut q = sim.start().to_vec();
    for (i, p) in sim.pairs().list().iter().enumerate() {
        println!("{} {} patches {}", p.fixed, p.moving, p.space.patch_count());
        for d in [-1e-2, -1e-4, -1e-6, -1e-8, 0.0, 1e-8, 1e-6, 1e-4, 1e-2] {
            q[0] = -9.136088754691971e-10;
            q[1] = -0.08239181951310123;
            q[2] = -0.1009009248708209;
            q[2] += d;
            // bring to contact by x
            let at = p.coordinates(sim.system(), &q);
            let t = p.touches(i, sim.system(), &q, 1e-3);
            println!(
                "{d:e} {:?} touches {:?} nearest {:?}",
                p.classify(sim.system(), &q),
                t.map(|t| t
                    .iter()
                    .map(|t| (
                        t.features.0.name,
                        t.features.1.name,
                        p.function(t, sim.system(), &q).value
                    ))
                    .collect::<Vec<_>>()),
                p.space
                    .nearest_contact(at)
                    .ok()
                    .flatten()
                    .map(|n| n.distance)
            );
        }
    }
}
