//! Tests of the material library.
