//! Mechanisms in motion.
//!
//! A [`Simulation`] holds a mechanism as a [`System`] of coordinates and the configuration space of every pair that can meet,
//! each computed once. Contacts are then not searched for along the way: the spaces know them.
//!
//! # Kinematic motion
//!
//! [`Simulation::kinematic`] follows motion without inertia while drives move slowly: forces balance at every instant,
//!
//! F + Σ λᵢ ∇fᵢ = 0 over all that is not driven, with λᵢ ≥ 0 for every closed contact i,
//!
//! stably, that is with a second derivative of V − Σ λᵢ fᵢ that is positive along what the closed contacts leave, V being the potential of
//! loads, weights and springs. Where that ends, parts go at once to the next balance: a [`EventKind::Snap`]. What no force acts on moves as
//! it is pushed: with the velocity nearest to rest, in the mass matrix of the outlines at unit density, that J v = drives, ∇fᵢ · v ≥ 0 allow. If
//! there is none the mechanism is jammed, and multipliers prove it. At a convex corner of the parts, where either of two contacts will do, the nearer
//! of the two velocities is taken.
//!
//! Contact functions fᵢ are those of [`cspace::FeatureContact`], in the model's unit of length; angles are in radians, times in
//! seconds.
//!
//! ```
//! use cspace::Part;
//! use cspace_model::{Drive, DriveMotion, Mechanism, PartEntry};
//! use cspace_motion::{EventKind, Settings, Simulation, Status};
//! // A block slides towards another and pushes it.
//! let mut mechanism = Mechanism::new("two blocks");
//! mechanism.parts.push(PartEntry::prismatic(Part::rectangle("pusher", (0.0, 0.0), 2.0, 2.0)?, (1.0, 0.0)));
//! mechanism.parts.push(PartEntry::planar(Part::rectangle("block", (4.0, 0.5), 2.0, 2.0)?));
//! mechanism.pairs = mechanism.every_two();
//! mechanism.dynamics.drives.push(Drive { part: 0, motion: DriveMotion::Rate(1.0) });
//! let record = Simulation::new(&mechanism)?.kinematic(&Settings { time: 5.0, every: None })?;
//! assert_eq!(record.status, Status::Done);
//! // They are 2 apart, and meet side to side.
//! assert!(record.events.iter().all(|e| e.kind == EventKind::Touch && (e.t - 2.0).abs() < 1e-9));
//! let end = record.samples.last().ok_or("there is one")?;
//! // x of the block: it is pushed from 2 s on and does not turn.
//! assert!((end.coordinates[1] - 3.0).abs() < 1e-9 && end.coordinates[3].abs() < 1e-9);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # By hand
//!
//! A [`Hand`] drags a part of a mechanism: it follows the same motion from one state to the next, with the part in place of all drives.
//!
//! # Dynamic motion
//!
//! [`Simulation::dynamic`] follows parts with masses from event to event, with impacts and friction; [`Simulation::stepping`] does so in
//! steps of one length, as a check. Both go through [`dynamic`], which integrates whatever is written down as a [`dynamic::World`].
//!
//! # How far it can be trusted
//!
//! Closed contacts and joints hold to 10⁻¹³ of the size; parts that are apart overlap at no sample by more than
//! [`MovingPair::touch`], some 10⁻¹⁰ of the size, and events are located to rounding where the motion is not tangent to a contact.
//! Whether parts that are apart meet within a step is asked of their space along five straight pieces that stand for the path of the step, where
//! their clearance does not answer it; steps move no part by more than a fiftieth of the mechanism's size.

// It reads no files and prints nothing.
#![warn(clippy::print_stdout, clippy::print_stderr)]

mod assemble;
mod complementarity;
mod contact;
pub mod cycle;
mod dormand_prince;
mod drive;
pub mod dynamic;
mod error;
mod exact_fit;
mod forces;
mod hand;
mod inertial;
mod kinematic;
mod linear;
mod pairs;
mod record;
mod report;
mod root;
mod simulate;
mod system;

pub use drive::{DriveCurve, Driven};
pub use error::SimulateError;
pub use exact_fit::Gap;
pub use forces::has_forces;
pub use hand::{Dragged, Ending, Hand, Stopper, Target};
pub use pairs::{MovingPair, Pairs, Touch};
pub use record::{
    Conduct, ContactForce, DriveForce, End, Energy, Event, EventKind, Forces, JointForce,
    MOST_TRACED, Obstacle, Record, Sample, Status, What,
};
pub use report::{
    ContactInterval, ContactPeak, Cycle, DrivePeak, Drop, PartCycle, Peak, Peaks, Pressing, Report,
    Swing, Trajectory,
};
pub use simulate::{Freedom, Settings, Simulation, Way};
pub use system::{PartCoordinates, Row, System};
