//! The sections of the report, one file each.

pub(super) mod asked;
pub(super) mod bubble;
pub(super) mod bubble_cloud;
pub(super) mod end;
pub(super) mod energy;
pub(super) mod fields;
pub(super) mod impacts;
pub(super) mod layers;
pub(super) mod load;
pub(super) mod probes;
pub(super) mod results;
pub(super) mod single_bubble;
pub(super) mod stepping;
pub(super) mod strain;
pub(super) mod wall;
