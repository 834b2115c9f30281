//! What the library is judged by: brute force, and drawn shapes.
