//! The end of each run in one picture.

use crate::report::{End, View, radius_picture};
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

/// The ends of several runs.
pub(super) struct Ends {
    /// One per run that has something to show.
    pub(super) pictures: Vec<Picture>,
    /// In words, what the pictures show.
    pub(super) told: &'static str,
    /// Sentences about runs without a picture.
    pub(super) absent: Vec<String>,
}

/// The end of each run (title, folder): its plastic strain, or the radius of its bubble where no metal yielded.
pub(super) fn small_multiples(runs: &[(String, PathBuf)], width: f64) -> Ends {
    let ends: Vec<End> = runs.iter().map(|(_, f)| End::read(f)).collect();
    let strained = ends.iter().filter_map(|end| match end {
        End::Strained(state) => state.view(),
        _ => None,
    });
    let views: Vec<View> = strained.collect();
    let common = common_view(&views);
    let (mut pictures, mut absent) = (Vec::new(), Vec::new());
    for ((title, folder), end) in runs.iter().zip(&ends) {
        match drawn(folder, title, width, end, common) {
            Ok(picture) => pictures.push(picture),
            Err(why) => absent.push(format!("{title}: {why}")),
        }
    }
    let elastic = ends.iter().any(|end| matches!(end, End::Elastic));
    let told = match (views.is_empty(), common, elastic) {
        (false, Some(_), _) => "All to one scale in space; colours by the bar of each.",
        (false, None, _) => "Each to its own scale in space; colours by the bar of each.",
        (true, _, true) => "No metal yielded: the radius of the bubble over time.",
        (true, _, false) => "The radius of the bubble over time.",
    };
    Ends {
        pictures,
        told,
        absent,
    }
}

/// The picture of one run, or why there is none.
fn drawn(
    folder: &Path,
    title: &str,
    width: f64,
    end: &End,
    common: Option<View>,
) -> Result<Picture, String> {
    let radius = |otherwise: &str| {
        let picture = radius_picture(folder, title, width).map(Picture::from);
        picture.ok_or_else(|| otherwise.to_owned())
    };
    match end {
        End::Unreadable(why) => Err(why.clone()),
        End::NoSolid => radius("no fields of a metal and no radius of a bubble were written."),
        End::Elastic => radius("the metal did not yield, and no radius of a bubble was written."),
        End::Strained(state) => match common.or_else(|| state.view()) {
            Some(view) => Ok(state.picture(title, view, width).into()),
            None => Err("its particles have no places that could be drawn.".to_owned()),
        },
    }
}

/// The plastic strain at the end of a run; none if nothing yielded or nothing was written.
#[must_use]
pub fn final_picture(folder: &Path, title: &str, width: f64) -> Option<Picture> {
    let End::Strained(end) = End::read(folder) else {
        return None;
    };
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

    /// A run whose pictures cannot be read is not one whose metal stayed elastic.
    #[test]
    fn what_cannot_be_read_is_said() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("fields.pvd"), "<VTKFile").unwrap();
        let runs = [("broken".to_owned(), folder.path().to_path_buf())];
        let ends = small_multiples(&runs, 100.0);
        assert!(ends.pictures.is_empty());
        assert!(!ends.told.contains("yielded"), "{}", ends.told);
        assert!(
            ends.absent[0].contains("broken: ")
                && ends.absent[0].contains("not as Erode writes it"),
            "{:?}",
            ends.absent
        );
    }

    #[test]
    fn alike_views_share_a_scale_and_unlike_ones_do_not() {
        let both = common_view(&[view(2.0, 1.0), view(1.0, 3.0)]).unwrap();
        assert_eq!(both, view(2.0, 3.0));
        assert_eq!(common_view(&[view(4.0, 1.0), view(1.0, 1.0)]), None);
        assert_eq!(common_view(&[]), None);
    }
}
