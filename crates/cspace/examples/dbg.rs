//! debug
fn main() {
    let name = std::env::args().nth(1).unwrap();
    if name == "all" {
        let t0 = std::time::Instant::now();
        for p in cspace_oracle::pairs() {
            if p.name == "gears 26 and 24" {
                continue;
            }
            let s = cspace::ContactSpace::compute(&p.fixed, &p.moving, &cspace::Options::default())
                .unwrap();
            let mut bad = 0;
            let mut worst = 0.0f64;
            let mut example = 0.0;
            let n = 40;
            for k in 0..n {
                let theta = -3.1 + 6.2 * ((k as f64 * 0.6180339887 + 0.1234) % 1.0);
                let a = cspace::Slice::compute(&p.fixed, &p.moving, theta);
                let b = s.slice(theta);
                let key = |s: &cspace::Slice| {
                    let mut v: Vec<_> = s
                        .curves
                        .iter()
                        .map(|c| (c.fixed, c.moving, (c.geometry.point(0.5).x * 1e3) as i64))
                        .collect();
                    v.sort();
                    v
                };
                let len =
                    |s: &cspace::Slice| s.curves.iter().map(|c| c.geometry.length()).sum::<f64>();
                let (ka, kb) = (key(&a), key(&b));
                if ka.len() != kb.len()
                    || ka.iter().zip(&kb).any(|(x, y)| (x.0, x.1) != (y.0, y.1))
                    || a.loops.len() != b.loops.len()
                {
                    bad += 1;
                    example = theta;
                }
                worst = worst.max((len(&a) - len(&b)).abs() / len(&a).max(1e-300));
                if b.curves.iter().any(|c| c.next == u32::MAX) {
                    bad += 100;
                    example = theta;
                }
            }
            if bad > 0 || s.statistics().conflicts > 0 || worst > 1e-8 {
                println!(
                    "{}: bad {bad} at {example} worst {worst:e} conflicts {}",
                    p.name,
                    s.statistics().conflicts
                );
            }
        }
        println!("{:?}", t0.elapsed());
        return;
    }
    let p = cspace_oracle::pair(&name);
    let s =
        cspace::ContactSpace::compute(&p.fixed, &p.moving, &cspace::Options::default()).unwrap();
    println!("{:#?}", s.statistics());
    println!(
        "crit {} patches {} side {} vert {} regions {:?}",
        s.critical_orientations().len(),
        s.patches().len(),
        s.side_links().len(),
        s.vertical_links().len(),
        s.free_regions()
    );
}
