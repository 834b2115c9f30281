//! Motions with known answers.

mod agreement;
mod answers;
mod axes;
mod balance;
mod drags;
mod dynamic_bodies;
mod dynamic_friction;
mod dynamic_hostile;
mod dynamic_impacts;
mod dynamic_joints;
mod dynamic_models;
mod dynamic_seams;
mod free_space;
mod friction;
mod hand;
mod heaps;
mod helpers;
mod hostile;
mod invariance;
mod many_contacts;
mod models;
mod oversize;
mod planar;
mod random;
mod taken_up;
mod turning;
