//! Gears with flanks of arcs.

use core::f64::consts::{FRAC_PI_2, PI, TAU};

use cspace::{Part, Point};

use super::pen::{Pen, bulge_of, bulge_through, part, polar};

/// The share of the pitch by which each tooth is thinner than the gap it enters, on each side.
const BACKLASH: f64 = 0.02;

/// A gear about the origin of `teeth` teeth of four arcs each; the middle of the first tooth is on the first axis.
///
/// A tooth is an arc of the tip circle, an arc of the root circle, and two convex arcs between that follow an involute
/// of 20°. Tips are sharp corners, and corners at the root are concave. Gears of one `module` mesh at a distance of
/// half the sum of their teeth times the module, or a little more.
pub fn gear(teeth: usize, module: f64) -> Part {
    let pitch = 0.5 * module * teeth as f64;
    let (tip, root) = (pitch + module, pitch - 1.25 * module);
    let step = TAU / teeth as f64;
    // Half the angle of the tooth at a radius.
    let pressure = 20.0_f64.to_radians();
    let base = pitch * pressure.cos();
    let involute = |r: f64| {
        let a = (base / r).min(1.0).acos();
        a.tan() - a
    };
    let half = |r: f64| step * (0.25 - BACKLASH) + involute(pitch) - involute(r);
    let at = |r: f64, angle: f64| polar(Point::ORIGIN, r, angle);
    // One flank's bulge serves all.
    let flank = bulge_through(
        at(root, -half(root)),
        at(pitch, -half(pitch)),
        at(tip, -half(tip)),
    );
    let top = bulge_of(2.0 * half(tip));
    let bottom = bulge_of(step - 2.0 * half(root));
    let first = at(root, -half(root));
    let mut pen = Pen::at(first.x, first.y);
    for i in 0..teeth {
        let middle = step * i as f64;
        let corners = [
            (at(tip, middle - half(tip)), flank),
            (at(tip, middle + half(tip)), top),
            (at(root, middle + half(root)), flank),
        ];
        for (p, bulge) in corners {
            pen = pen.arc(p.x, p.y, bulge);
        }
        if i + 1 < teeth {
            let p = at(root, middle + step - half(root));
            pen = pen.arc(p.x, p.y, bottom);
        }
    }
    part(format!("gear {teeth}"), vec![pen.close_arc(bottom)])
}

/// A rack of `teeth` straight teeth along the first axis, their tips on one line, on a bar of height `module`.
///
/// The tips are at y = `module`, the pitch line is the first axis, and the first tooth is about x = 0.
pub fn rack(teeth: usize, module: f64) -> Part {
    let pitch = PI * module;
    let slope = 20.0_f64.to_radians().tan();
    let half = |y: f64| pitch * (0.25 - BACKLASH) - y * slope;
    let (tip, root) = (module, -1.25 * module);
    let (left, right) = (-0.5 * pitch, (teeth as f64 - 0.5) * pitch);
    let mut pen = Pen::at(left, root - module)
        .line(right, root - module)
        .line(right, root);
    for i in (0..teeth).rev() {
        let x = pitch * i as f64;
        pen = pen
            .line(x + half(root), root)
            .line(x + half(tip), tip)
            .line(x - half(tip), tip)
            .line(x - half(root), root);
    }
    part(format!("rack {teeth}"), vec![pen.line(left, root).close()])
}

/// A ratchet wheel about the origin whose tips are 1 apart, so that it grows with the number of its teeth.
///
/// Each tooth has a straight radial face, half as long as the pitch, which faces clockwise, and an arc for a back.
/// The first face is on the first axis.
pub fn ratchet(teeth: usize) -> Part {
    let tip = 0.5 / (PI / teeth as f64).sin();
    let root = tip - 0.5;
    let step = TAU / teeth as f64;
    let back = bulge_of(0.2 * FRAC_PI_2);
    let mut pen = Pen::at(root, 0.0);
    for i in 0..teeth {
        let p = polar(Point::ORIGIN, tip, step * i as f64);
        pen = pen.line(p.x, p.y);
        if i + 1 < teeth {
            let q = polar(Point::ORIGIN, root, step * (i + 1) as f64);
            pen = pen.arc(q.x, q.y, back);
        }
    }
    part(format!("ratchet {teeth}"), vec![pen.close_arc(back)])
}

/// A pawl for a [`ratchet`], of 8 features: an arc about its pivot at the origin, four lines, three convex corners.
///
/// It points along the first axis; its tip is at (3, −0.1).
pub fn pawl() -> Part {
    part(
        "pawl",
        vec![
            Pen::at(0.0, -0.4)
                .line(2.0, -0.4)
                .line(3.0, -0.1)
                .line(2.4, 0.4)
                .line(0.0, 0.4)
                .close_arc(1.0),
        ],
    )
}
