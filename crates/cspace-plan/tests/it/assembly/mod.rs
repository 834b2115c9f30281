//! Assemblies of which it is known whether and how they come apart. Every step is judged by distances and by brute force.

mod comes_apart;
mod judged;
mod makes_room;
mod played;
mod stays_together;
mod ten;
