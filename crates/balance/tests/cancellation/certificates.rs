//! Proofs recomputed for every engine of the gallery.
