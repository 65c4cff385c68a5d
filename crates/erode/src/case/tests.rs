//! Tests of reading cases.
