//! Where tracks lead out.

use cspace::Vector;

use crate::legs::Coords;

use super::tracks::{Track, Tracks};

/// A track along which a part comes out at a flatter angle than this does not lead out: a sine.
const STEEP: f64 = 0.1;

/// Where a way may end beside its last place: where a planar part at an orientation (radians) is out, as directions d with the least
/// p · d of its place p.
pub(crate) type Outside<'o> = dyn Fn(f64) -> Vec<(Vector, f64)> + 'o;

/// Whether a place is out.
pub(super) fn is_out(outside: &Outside<'_>, at: Coords, size: f64) -> bool {
    /// Places are rounded by this share of the parts' size.
    const ROUNDING: f64 = 1e-12;
    let place = Vector::new(at[0], at[1]);
    (outside(at[2]).iter()).any(|&(d, least)| d.dot(place) >= least - ROUNDING * size)
}

/// Where tracks come out: of each orientation, track and way along it the place on it, as a coordinate along the track.
#[derive(Debug)]
pub(super) struct Outs(Vec<Vec<[f64; 2]>>);

impl Outs {
    pub(super) fn new(tracks: &Tracks, outside: Option<&Outside<'_>>) -> Self {
        let Some(outside) = outside else {
            return Self(Vec::new());
        };
        let of = |&angle: &f64| {
            let least = outside(angle);
            let on = |track: &Track| {
                [1.0, -1.0].map(|way| {
                    let along = track.direction * way;
                    let base = track.point(0.0).to_vector();
                    let times = least.iter().filter_map(|&(d, least)| {
                        let rate = d.dot(along);
                        (rate > STEEP).then(|| (least - d.dot(base)) / rate)
                    });
                    way * times.fold(f64::INFINITY, f64::min)
                })
            };
            tracks.tracks.iter().map(on).collect()
        };
        Self(tracks.angles.iter().map(of).collect())
    }

    /// Where a track comes out when it is followed ahead or back.
    pub(super) fn at(&self, angle: u32, line: u32, ahead: bool) -> Option<f64> {
        let out = self.0.get(angle as usize)?[line as usize][usize::from(!ahead)];
        out.is_finite().then_some(out)
    }
}
