//! Times of fixed-axes pairs.
fn main() {
    use cspace::FixedAxesSpace;
    use cspace_oracle::shapes::mechanisms::{gears, geneva, mechanisms};
    let mut all = vec![gears(10, 9), gears(14, 12), geneva(6, 0.05)];
    all.extend(mechanisms());
    for m in &all {
        let mut best = f64::INFINITY;
        let mut stats = None;
        for _ in 0..5 {
            let t = std::time::Instant::now();
            let space = FixedAxesSpace::compute(&m.fixed, m.fixed_axis, &m.moving, m.moving_axis);
            best = best.min(t.elapsed().as_secs_f64());
            stats = space.ok().map(|s| s.statistics());
        }
        println!("{:34} {:8.3} ms {stats:?}", m.name, 1e3 * best);
    }
}
