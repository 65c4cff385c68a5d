//! The final numbers of a run of a cloud.

use super::Present;
use crate::output::Summary;

pub(super) fn summary(p: &Present, wall_time: f64) -> Summary {
    let mut s = Summary::default();
    let l = &p.cloud.ledger;
    s.set_count("bubbles", p.cloud.len() as u64);
    s.set_count("collapses", l.collapses);
    s.set_count("impacts", l.impacts);
    s.set("largest_bubble_radius", "m", p.largest_radius);
    s.set("smallest_bubble_radius", "m", p.smallest_radius);
    let peak = if l.impacts > 0 {
        p.peak_impact
    } else {
        f64::NAN
    };
    s.set("max_impact_pressure", "Pa", peak);
    s.set("end_time", "s", p.cloud.time);
    s.set("wall_time", "s", wall_time);
    s.set_count("threads", rayon::current_num_threads() as u64);
    s.set_version("erode", env!("CARGO_PKG_VERSION"));
    let gone = l.left_domain + l.closed + l.failed;
    let present = p.cloud.len() as u64;
    #[allow(clippy::cast_precision_loss)] // counts
    let unaccounted = l.injected as f64 - (gone + present) as f64;
    s.set_ledger("bubbles_unaccounted", "-", unaccounted);
    let counts = [
        ("bubbles_injected", l.injected),
        ("bubbles_left_domain", l.left_domain),
        ("bubbles_closed", l.closed),
        ("bubbles_failed", l.failed),
        ("collapses_too_near", l.too_near),
        ("collapses_too_far", l.too_far),
        ("collapses_without_wall", l.no_wall),
        ("collapses_not_assessed", l.not_assessed),
        ("wall_contacts", l.wall_contacts),
        ("average_points_left_out", l.average_points_left_out),
    ];
    for (name, count) in counts {
        #[allow(clippy::cast_precision_loss)] // counts
        s.set_ledger(name, "-", count as f64);
    }
    s.set_limiter("substeps", l.substeps);
    s
}
