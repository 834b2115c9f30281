//! Tolerances that determine the resolution of the kernel, each with its unit and reason.
//!
//! Bounds on rounding errors, and limits of iterations, are defined where they are used.
//!
//! Lengths are in units of the pair's frame, in which both parts fit the unit disc.

// Growth: changes of the parts as drawn.

/// Length by which the fixed part is grown before anything is computed (about 9.1e-13).
///
/// It is the regularised meaning of a contact in numbers: a clearance below it counts as none. It turns every coincidence that would last
/// over a range of orientations (zero clearance, equal radii, a corner that exactly fills another) into a definite overlap some thousand
/// times larger than the rounding of f64.
pub(crate) const GROWTH: f64 = 1.0 / (1u64 << 40) as f64;

/// Length by which the moving part is grown (about 2.1e-13).
///
/// Where lengths of the fixed part alone equal one of the moving part, as a step as high as the radius of a disc that rolls over it, growth
/// of the fixed part changes nothing, because both ends of the length are moved. Growth of the other part does. It is much smaller than
/// [`GROWTH`], and not a simple fraction of it.
pub(crate) const MOVING_GROWTH: f64 = 0.236_067_977_499_789_7 * GROWTH;

/// Length by which the moving part is shrunk, instead of grown, where exact fits are sought (about 9.3e-10).
///
/// Parts that fit exactly then have a play of twice as much, four times [`LEAST_CLEARANCE`], and so have parts that overlap by slightly
/// less than that. A pair of discs inside the parts is shrunk by more, so that it still certainly overlaps.
pub(crate) const ROOM: f64 = 1.0 / (1u64 << 30) as f64;

/// Displacement of vertices of the moving part where it is shrunk by [`ROOM`] (length, about 5.8e-11): a part that fits exactly in several
/// places would have the same play in each, and its contacts would be tangent to each other.
pub(crate) const MOVED_IN_ROOM: f64 = ROOM / 16.0;

/// The longest mitre of a grown convex corner, in units of [`GROWTH`]; sharper corners are cut off there.
///
/// It is the largest displacement of a contact at the corner, 9.3e-10, and included in the resolution of a pair.
pub(crate) const MITRE: f64 = 1024.0;

/// Length by which edges that meet in a concave corner are extended into the material, in units of [`GROWTH`].
///
/// Nothing can touch a concave corner, so contact curves end there in blocked space. The extension makes them cross each other properly
/// instead of sharing an end point.
pub(crate) const OVERSHOOT: f64 = 64.0;

/// The separation that the extension must give at nearly smooth concave corners (length, about 1.4e-14).
pub(crate) const OVERSHOOT_SEPARATION: f64 = 1.0 / (1u64 << 46) as f64;

/// Displacement of vertices of the fixed part that makes it generic (length, about 1.1e-13): less than its growth, so that the grown part
/// still covers the part as drawn.
pub(crate) const PERTURBATION: f64 = GROWTH / 8.0;

/// How much more a layer of a part is grown than the one before it, in units of the displacement of its vertices.
///
/// Sides that are flush in the drawing are moved by at most one unit each, so that the side of the layer that is grown more covers the other
/// by two units or more at every place.
pub(crate) const LAYER_STEP: f64 = 4.0;

/// Displacement of vertices of the moving part that makes it generic (length, about 5.4e-14).
pub(crate) const MOVING_PERTURBATION: f64 = MOVING_GROWTH / 4.0;

/// The smallest displacement of a vertex along an axis, as a fraction of the largest.
pub(crate) const LEAST_WISH: f64 = 0.25;

/// Ratio of the cost of moving a vertex laterally to that of sliding it by the same length.
///
/// A kink δ where an arc of radius r meets an edge of length l is removed by a slide of r δ if l is more than r / SLIDE, and otherwise by
/// turning the edge, which moves its end by l δ: that is at most r δ / SLIDE ≈ 1e-13, and the slide at most SLIDE δ ≈ 1/500 of the edge.
pub(crate) const SLIDE: f64 = (1u32 << 17) as f64;

/// Fraction of a short edge by which its ends may be moved as easily as those of a long one. They are never moved by more than twice as
/// much.
pub(crate) const LARGEST_PART: f64 = 1.0 / 64.0;

/// Largest requested displacement of the ends of a short edge, as a fraction of its length.
pub(crate) const WISHED_PART: f64 = 1.0 / (1u32 << 16) as f64;

/// Largest requested change of an arc's sagitta, as a fraction of it; larger changes cost more.
pub(crate) const SAGITTA_PART: f64 = 1.0 / 1024.0;

/// Upper bound of a vertex's lateral displacement, as a multiple of the largest requested one.
pub(crate) const MOST_WISHES: f64 = 4.0;

// Features: when they are smooth, straight, large or one.

/// Angle below which two edges, one of them an arc, are smoothly joined (radians, about 1.5e-8).
///
/// The resulting error of the boundary is of second order: radius × SMOOTH² / 2, below the rounding of f64.
pub(crate) const SMOOTH: f64 = 1.0 / (1u64 << 26) as f64;

/// Sweep below which an arc is replaced by its chord, and half the angle below which two lines are one (radians, about 2.3e-10).
///
/// The arc is within 2⁻³⁵ ≈ 2.9e-11 of the length of the chord. The range of orientations at which it touches a line equals its sweep; so
/// it is at least about [`NARROWEST_BAND`].
pub(crate) const STRAIGHT: f64 = 1.0 / (1u64 << 32) as f64;

/// Largest displacement of an end, as a fraction of its edge, where two edges are joined smoothly beside their vertex.
pub(crate) const MOVED_PART: f64 = 1.0 / 1024.0;

/// Length, or sine of an angle, that is nothing beside [`GROWTH`] (about 1.1e-13): an arc as high over its chord is the chord, and a
/// corner where carriers part by as much is none.
pub(crate) const NEGLIGIBLE: f64 = GROWTH / 8.0;

/// Distance of carriers, at every orientation, below which they are one, or tangent, by construction (length and sine of an angle, about
/// 3.6e-15), times the radius if that is larger.
///
/// It is the rounding of f64, with a factor of two: centres, radii and normals are exact to 2⁻⁵³ of themselves; a centre is turned and moved
/// by four more operations, and of two sheets each has one; their distance, and the sums of radii, take as many again. It is less than
/// the perturbation of any vertex, which separates carriers that merely coincide in the drawing. On large circles both grow: the centre of
/// an arc of radius r within the unit disc moves by at least 2 r² times what its middle moves.
pub(crate) const SAME_CARRIER: f64 = 16.0 * f64::EPSILON;

/// Radius above which circles are written by a point near them instead of by their centres (length).
///
/// A place on a circle about its centre is as accurate as the radius times the rounding of f64: up to here that is a thirtieth of
/// [`GROWTH`].
pub(crate) const LARGEST_CIRCLE: f64 = 128.0;

// Contacts.

/// Distance from a contact curve below which a position is in contact (length, about 7.3e-12): several times the growth of the parts,
/// unless they have sharp corners.
pub(crate) const CONTACT: f64 = 8.0 * GROWTH;

/// Radius below which a circle of contact is ignored (length).
///
/// A pin in a socket with less play than this counts as an exact fit.
pub(crate) const SMALLEST_CIRCLE: f64 = 8.0 * GROWTH;

/// Radius below which f64 does not resolve places on a circle (length).
pub(crate) const SMALL_CIRCLE: f64 = 1e-6;

/// Distance of centres of circles below which they are close (length): farther ones are known to 1e-10 of their distance.
pub(crate) const CLOSE_CENTERS: f64 = 1.0 / (1u64 << 20) as f64;

/// The largest distance of two positions in contact (length): each part fits the unit disc.
pub(crate) const LONGEST: f64 = 4.0;

/// Upper bound of the height of the arc of a large circle over its chord (length).
///
/// One of the arcs that touch is large, so it and the other feature turn by no more than [`LONGEST`] / [`LARGEST_CIRCLE`].
pub(crate) const WIDEST_SAGITTA: f64 = 0.125 * LONGEST * LONGEST / LARGEST_CIRCLE;

/// Largest angle about their centres at which flat arcs are followed (radians): the pieces near the parts are far smaller.
pub(crate) const WIDEST_ARC: f64 = 0.5;

/// Distance of the orientations at which tangency is tested to decide whether curves are tangent at every orientation (radians): flat arcs
/// can be followed as far.
pub(crate) const TANGENCY_STEP: f64 = 0.1;

/// Minimum distance of the cut of the full turn from any orientation at which two normals oppose each other (radians), unless these are too
/// dense.
pub(crate) const CLEAR_CUT: f64 = 1e-7;

/// Depth of a point that is in the material whatever the growth (length).
pub(crate) const WITHIN: f64 = 4.0 * GROWTH;

// Contact spaces.

/// Distance of critical orientations below which they are one (radians, about 1.2e-10): bands are at least this wide.
///
/// Growth and the perturbation of vertices open pockets that the drawing does not have, and close others; these last about 1e-12 rad,
/// divided by the rate at which the contacts part. Bands a hundred times wider are those of the drawing.
pub(crate) const NARROWEST_BAND: f64 = 1.0 / (1u64 << 33) as f64;

/// Play above which a fit is resolved (length, about 4.7e-10).
///
/// A part of the frame's size with a play c can turn by about c, one with long teeth by a half or a third of it: four times
/// [`NARROWEST_BAND`].
pub(crate) const LEAST_CLEARANCE: f64 = 4.0 * NARROWEST_BAND;

/// Minimum length of a patch that vertical neighbours must share to be linked.
pub(crate) const SHORTEST_OVERLAP: f64 = 1e-11;

// Slices.

/// Distance within which ends of a slice's curves that are not joined otherwise are one place (length).
///
/// Curves that touch cross at a place known to the square root of the rounding, and beside a tangency a critical orientation is known to
/// 1e-6 rad: curves of the band before may appear in the band after.
pub(crate) const TORN: f64 = 1e-6;

/// Distance from the joint of two curves within which a ray meets them (length).
///
/// It is above the rounding of such places; a ray is reported free only up to that.
pub(crate) const JOINT: f64 = 1e-11;

/// Distance of facing curves of a slice above which the order in which a ray meets them is right, as a fraction of the distance to the
/// first.
pub(crate) const FACING: f64 = 1e-7;

/// The corresponding bound as a fraction of the distance to the farthest end of a curve; at least [`LEAST_CLEARANCE`] if that is a size
/// away: the space between them may have closed just there, and at a critical orientation they may have passed each other by so much.
pub(crate) const FACING_FAR: f64 = 1e-9;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::part::tolerance::MAX_LAYERS;

    /// Tolerances that separate are larger than what they separate from, and smaller than what they must not reach.
    #[test]
    fn tolerances_are_in_the_order_of_their_meanings() {
        let kink = 0.5 * SMOOTH * SMOOTH;
        let moved = LEAST_WISH * MOVING_PERTURBATION;
        let far = LARGEST_CIRCLE * f64::EPSILON;
        // From the rounding of f64 to growth: what is one by construction, what is moved apart, what both parts are grown by.
        let apart = [
            kink,
            f64::EPSILON,
            SAME_CARRIER,
            moved,
            MOVING_PERTURBATION,
            MOVING_GROWTH,
            GROWTH,
        ];
        // From growth to what a user sees: contacts, bands, clearances, angles.
        let resolved = [
            GROWTH,
            WITHIN,
            CONTACT,
            SHORTEST_OVERLAP,
            NARROWEST_BAND,
            LEAST_CLEARANCE,
            ROOM,
            SMOOTH,
        ];
        let others = [
            [SAME_CARRIER, OVERSHOOT_SEPARATION],
            [SAME_CARRIER, NEGLIGIBLE],
            [NEGLIGIBLE, MOVING_GROWTH],
            // With the most layers, the displacement of vertices stays above rounding.
            [
                SAME_CARRIER,
                LEAST_WISH * 5.0 * MOVING_GROWTH / (LAYER_STEP * MAX_LAYERS as f64),
            ],
            // Moved vertices stay within the growth.
            [MOST_WISHES * PERTURBATION, GROWTH],
            [MOVING_PERTURBATION, PERTURBATION],
            [far, NEGLIGIBLE],
            [MOVED_IN_ROOM, ROOM],
            [NARROWEST_BAND, STRAIGHT],
        ];
        let chains = [&apart[..], &resolved[..]];
        let steps = chains.iter().flat_map(|c| c.windows(2));
        for step in steps.chain(others.iter().map(|o| &o[..])) {
            assert!(step[0] < step[1], "{step:?}");
        }
    }
}
