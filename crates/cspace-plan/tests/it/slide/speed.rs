//! How long a motion takes: printed, not judged, for machines differ.

use std::time::Instant;

use cspace_plan::slide::Slider;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

use crate::slide::models::all;
use crate::slide::random::Pair;

const DRAGS: usize = 12;
const STEPS: usize = 40;

#[test]
#[ignore = "prints times"]
fn how_long_a_slide_takes() {
    println!("µs: first, median, mean, most of slides; median of advances");
    for (name, space) in all() {
        let pair = Pair::new(&space);
        let mut rng = ChaCha8Rng::seed_from_u64(5);
        let (mut slides, mut advances) = (Vec::new(), Vec::new());
        let slider = Slider::new(&space);
        for _ in 0..DRAGS {
            let mut at = pair.free(&mut rng);
            let goal = pair.weighted.within(pair.weighted.anywhere(&mut rng));
            let g = pair.weighted.vector(goal);
            for i in 1..=STEPS {
                let a = pair.weighted.vector(at);
                let left = (STEPS + 1 - i) as f64;
                let next = core::array::from_fn(|k| a[k] + (g[k] - a[k]) / left);
                let next = pair.weighted.configuration(next);
                let begin = Instant::now();
                slider.advance(at, next).unwrap();
                advances.push(1e6 * begin.elapsed().as_secs_f64());
                let begin = Instant::now();
                at = slider.slide(at, next).unwrap().at;
                slides.push(1e6 * begin.elapsed().as_secs_f64());
            }
        }
        let first = slides[0];
        let mean = slides.iter().sum::<f64>() / slides.len() as f64;
        slides.sort_by(f64::total_cmp);
        advances.sort_by(f64::total_cmp);
        let (middle, last) = (slides.len() / 2, slides.len() - 1);
        let features = space.features();
        println!(
            "{name:44} {:4} features {:6} patches: {first:8.0} {:8.0} {mean:8.0} {:8.0}; {:8.0}",
            features.fixed + features.moving,
            space.patch_count(),
            slides[middle],
            slides[last],
            advances[middle],
        );
    }
}
