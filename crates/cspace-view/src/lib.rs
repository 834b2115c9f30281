//! A page that shows parts and their configuration spaces, served on loopback or written as one file.
