//! A run at its end in one picture, for comparisons of several runs.

use super::fields::{largest_strain, percent, strain_layer};
use crate::output::RunPaths;
use crate::report::picture::Picture;
use crate::report::plot::{Axis, Plot};
use crate::report::raster::View;
use crate::report::run_data::points;
use crate::report::snapshot::{Body, read_frames};
use crate::report::view::strained_view;
use std::path::Path;

/// What the last snapshot of a run shows.
pub(crate) enum End {
    /// A solid with plastic strain.
    Strained(EndState),
    /// A solid that stayed elastic.
    Elastic,
    /// No solid, or no snapshot.
    NoSolid,
    /// Nothing that could be read, and why.
    Unreadable(String),
}

/// The solids of a run in its last snapshot.
pub(crate) struct EndState {
    solids: Vec<Body>,
    /// Largest plastic strain.
    pub(crate) largest: f64,
}

impl End {
    /// Of a run folder.
    pub(crate) fn read(run_dir: &Path) -> Self {
        let frames = match read_frames(&RunPaths::new(run_dir)) {
            Ok(frames) => frames,
            Err(trouble) => return Self::Unreadable(trouble),
        };
        let Some(last) = frames.last() else {
            return Self::NoSolid;
        };
        let (bodies, troubles) = last.read();
        let solids: Vec<Body> = bodies.into_iter().filter(Body::is_solid).collect();
        let largest = largest_strain(&solids);
        // A body that cannot be read may be the one that yielded.
        if largest > 0.0 {
            Self::Strained(EndState { solids, largest })
        } else if !troubles.is_empty() {
            Self::Unreadable(troubles.join(" "))
        } else if solids.is_empty() {
            Self::NoSolid
        } else {
            Self::Elastic
        }
    }
}

impl EndState {
    /// The region that yielded.
    pub(crate) fn view(&self) -> Option<View> {
        strained_view(&self.solids, self.largest)
    }

    /// Plastic strain in `view`; SVG and caption.
    pub(crate) fn picture(&self, title: &str, view: View, width: f64) -> (String, String) {
        let layers = self.solids.iter();
        let layers = layers.filter_map(|b| strain_layer(b, self.largest));
        let picture = Picture {
            title: title.to_owned(),
            view,
            mirrored: true,
            layers: layers.collect(),
            width,
            axes: ["r", "z"],
        };
        let caption = format!("{title}: largest plastic strain {}.", percent(self.largest));
        (picture.to_svg(), caption)
    }
}

/// The radius of the bubble over time, for runs without a solid; SVG and caption.
pub(crate) fn radius_picture(run_dir: &Path, title: &str, width: f64) -> Option<(String, String)> {
    let history = crate::output::Table::read(&RunPaths::new(run_dir).history()).ok()?;
    let curve = points(history.column("time")?, history.column("bubble_radius")?);
    let plot = Plot::new(Axis::new("time", "s"), Axis::new("bubble radius", "m"));
    let plot = plot
        .titled(title)
        .sized(width, 0.65 * width)
        .line("", curve);
    Some((plot.to_svg(), format!("{title}: radius of the bubble.")))
}
