//! Values that Joshi 2018 prints for its two cases of chapter 6: 0.15 mm, 50 MPa, A-2205 steel.

/// Largest plastic strain of the detached cavity, stand-off 1.33 (section 6.4.1, figure 6.7).
pub const DETACHED_STRAIN: f64 = 0.0023;
/// The same without strain-rate effect (section 6.4.3, figure 6.10).
pub const DETACHED_STRAIN_WITHOUT_RATE: f64 = 0.0037;
/// Largest plastic strain of the attached cavity, stand-off 0.66 (section 6.4.1, figure 6.8).
pub const ATTACHED_STRAIN: f64 = 0.0083;
/// The same when the jet has hit, before the ring collapses.
pub const ATTACHED_STRAIN_BY_JET: f64 = 0.0042;
/// The same below the ring.
pub const ATTACHED_STRAIN_BELOW_RING: f64 = 0.002;
/// Where the largest strain of the detached cavity lies, m from the axis (section 6.4.4.2): between these.
pub const DETACHED_OFFSET: [f64; 2] = [0.1e-3, 0.2e-3];
