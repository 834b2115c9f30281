//! A box slides over seams of flush tiles, small steps down and notches, and goes on behind them.

use cspace_motion::Status;

use crate::motion::helpers::{balanced, near, thrown};

/// Corners of a loop, scaled by `size` and turned by an angle.
fn outline(corners: &[(f64, f64)], size: f64, slope: f64) -> String {
    let (sin, cos) = slope.sin_cos();
    let corners = corners.iter().map(|&(x, y)| {
        let (x, y) = (x * size, y * size);
        format!("[{:?}, {:?}]", x * cos - y * sin, x * sin + y * cos)
    });
    format!("[[{}]]", corners.collect::<Vec<_>>().join(", "))
}

/// A box 2 wide that leaves x = 3 with 5 units a second, on floors, for 2 s; across the slope there is gravity. It arrives at 13.
#[track_caller]
fn slides(floors: &[Vec<(f64, f64)>], size: f64, slope: f64, drop: f64) {
    let (sin, cos) = slope.sin_cos();
    let g = 9.81 * size;
    let mut text = format!("gravity = [{:?}, {:?}]\n", g * sin, -g * cos);
    for (i, floor) in floors.iter().enumerate() {
        text += &format!(
            "[[part]]\nname = \"floor {i}\"\nmotion = {{ type = \"fixed\" }}\nloops = {}\n",
            outline(floor, size, slope)
        );
    }
    let (x, v) = (3.0 * size, 5.0 * size);
    text += &format!(
        "[[part]]\nname = \"box\"\nmass = 1\nloops = {}\nstart = [{:?}, {:?}, 0]\nrate = [{:?}, {:?}, 0]\n",
        outline(
            &[(-1.0, 0.0), (1.0, 0.0), (1.0, 2.0), (-1.0, 2.0)],
            size,
            slope
        ),
        x * cos,
        x * sin,
        v * cos,
        v * sin
    );
    for i in 0..floors.len() {
        text += &format!("[[pair]]\nfixed = \"floor {i}\"\nmoving = \"box\"\n");
    }
    let (_, record) = thrown(&text, 2.0, 2.0);
    assert_eq!(record.status, Status::Done, "{:?}", record.reason);
    let last = record.samples.last().unwrap();
    let [q, rates] = [&last.coordinates, &last.rates];
    // On its way down it may turn by what the step is to its width.
    let slack = 4.0 * drop + 1e-9;
    near("way", (q[0] * cos + q[1] * sin) / size, 13.0, slack);
    near("height", (q[1] * cos - q[0] * sin) / size, 0.0, slack);
    let kinetic = 0.5 * (rates[0] * rates[0] + rates[1] * rates[1]) / (size * size);
    // The step's height gives m g h, of which the landing takes some.
    near(
        "kinetic energy",
        kinetic / 12.5,
        1.0,
        9.81 * drop / 12.5 + 1e-12,
    );
    balanced(&record, 12.5 * size * size, 1e-12);
}

/// Two tiles, the second lower by a step.
fn tiles(step: f64) -> Vec<Vec<(f64, f64)>> {
    vec![
        vec![(0.0, -1.0), (10.0, -1.0), (10.0, 0.0), (0.0, 0.0)],
        vec![(10.0, -1.0), (20.0, -1.0), (20.0, -step), (10.0, -step)],
    ]
}

#[test]
fn over_flush_tiles_and_small_steps_down() {
    for size in [1e-3, 1.0, 1e3] {
        for step in [0.0, 1e-12, 1e-11, 1e-10, 1e-9, 1e-8, 1e-7] {
            println!("size {size:e}, step {step:e}");
            slides(&tiles(step), size, 0.0, step);
        }
    }
}

#[test]
fn over_flush_tiles_on_a_slope() {
    for slope in [0.3, -1.2, 2.0] {
        slides(&tiles(0.0), 1.0, slope, 0.0);
    }
}

/// A notch narrower than the box, and a gap between two tiles.
#[test]
fn over_a_notch_and_a_gap() {
    let mut notch = vec![(0.0, -1.0), (20.0, -1.0), (20.0, 0.0)];
    notch.extend([(6.5, 0.0), (6.5, -0.5), (6.0, -0.5), (6.0, 0.0), (0.0, 0.0)]);
    slides(&[notch], 1.0, 0.0, 0.0);
    let gap = vec![
        vec![(0.0, -1.0), (6.0, -1.0), (6.0, 0.0), (0.0, 0.0)],
        vec![(6.5, -1.0), (20.0, -1.0), (20.0, 0.0), (6.5, 0.0)],
    ];
    slides(&gap, 1.0, 0.0, 0.0);
}
