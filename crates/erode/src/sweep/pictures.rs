//! The end of each run in one picture.

use crate::report::{EndState, View, radius_picture};
use std::path::{Path, PathBuf};

/// Views whose widths differ by more than this factor are not drawn to one scale: the smaller would not be seen.
const COMPARABLE: f64 = 3.0;

/// A picture with what is to be said about it.
#[derive(Debug, Clone, PartialEq)]
pub struct Picture {
    /// The picture.
    pub svg: String,
    /// What it shows.
    pub caption: String,
}

impl From<(String, String)> for Picture {
    fn from((svg, caption): (String, String)) -> Self {
        Self { svg, caption }
    }
}

/// One picture per run (title, folder) that has one: its plastic strain, or the radius of its bubble where there is no
/// metal. Whether all were drawn to one scale; none without metal that yielded.
pub(super) fn small_multiples(
    runs: &[(String, PathBuf)],
    width: f64,
) -> (Vec<Picture>, Option<bool>) {
    let ends: Vec<Option<EndState>> = runs.iter().map(|(_, f)| EndState::read(f)).collect();
    let views: Vec<View> = ends.iter().flatten().filter_map(EndState::view).collect();
    let common = common_view(&views);
    let pictures = runs.iter().zip(&ends).filter_map(|((title, folder), end)| {
        let drawn = match end {
            Some(end) => Some(end.picture(title, common.or_else(|| end.view())?, width)),
            None => radius_picture(folder, title, width),
        };
        drawn.map(Picture::from)
    });
    let one_scale = (!views.is_empty()).then_some(common.is_some());
    (pictures.collect(), one_scale)
}

/// The plastic strain at the end of a run; none if nothing yielded or nothing was written.
#[must_use]
pub fn final_picture(folder: &Path, title: &str, width: f64) -> Option<Picture> {
    let end = EndState::read(folder)?;
    let view = end.view()?;
    Some(end.picture(title, view, width).into())
}

fn common_view(views: &[View]) -> Option<View> {
    let width = |v: &View| v.r[1] - v.r[0];
    let widest = views.iter().map(width).fold(0.0, f64::max);
    let narrowest = views.iter().map(width).fold(f64::INFINITY, f64::min);
    if widest > COMPARABLE * narrowest {
        return None;
    }
    views.iter().copied().reduce(|a, b| View {
        r: [a.r[0].min(b.r[0]), a.r[1].max(b.r[1])],
        z: [a.z[0].min(b.z[0]), a.z[1].max(b.z[1])],
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn view(reach: f64, depth: f64) -> View {
        View {
            r: [-reach, reach],
            z: [-depth, 0.0],
        }
    }

    #[test]
    fn alike_views_share_a_scale_and_unlike_ones_do_not() {
        let both = common_view(&[view(2.0, 1.0), view(1.0, 3.0)]).unwrap();
        assert_eq!(both, view(2.0, 3.0));
        assert_eq!(common_view(&[view(4.0, 1.0), view(1.0, 1.0)]), None);
        assert_eq!(common_view(&[]), None);
    }
}
