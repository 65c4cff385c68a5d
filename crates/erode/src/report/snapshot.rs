//! Snapshots of particles: which there are, and one of them as the pictures need it.

use std::path::PathBuf;

use crate::output::{Collection, OutputError, RunPaths, Snapshot};

/// An instant for which snapshots were written.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Frame {
    /// Simulated time, s.
    pub(crate) time: f64,
    /// Name and file of each body.
    pub(crate) bodies: Vec<(String, PathBuf)>,
}

impl Frame {
    /// The bodies of this instant; sentences about those that cannot be read.
    pub(crate) fn read(&self) -> (Vec<Body>, Vec<String>) {
        let mut bodies = Vec::new();
        let mut troubles = Vec::new();
        for (name, path) in &self.bodies {
            match Body::read(name, path) {
                Ok(body) => bodies.push(body),
                Err(trouble) => troubles.push(trouble),
            }
        }
        (bodies, troubles)
    }
}

/// The instants of a run in order of time; none if nothing was written.
pub(crate) fn read_frames(paths: &RunPaths) -> Result<Vec<Frame>, String> {
    let path = paths.collection();
    if !path.is_file() {
        return Ok(Vec::new());
    }
    let collection = Collection::read(&path).map_err(|e| format!("{e}; there are no pictures."))?;
    let mut frames: Vec<Frame> = Vec::new();
    for entry in collection.entries() {
        let body = (entry.name.clone(), path.with_file_name(&entry.file));
        match frames.iter_mut().find(|f| f.time == entry.time) {
            Some(frame) => frame.bodies.push(body),
            None => frames.push(Frame {
                time: entry.time,
                bodies: vec![body],
            }),
        }
    }
    frames.sort_by(|a, b| a.time.total_cmp(&b.time));
    Ok(frames)
}

/// The particles of one body at one instant.
#[derive(Debug, Clone)]
pub(crate) struct Body {
    pub(crate) name: String,
    /// (r, z), m.
    pub(crate) position: Vec<[f64; 2]>,
    /// Spacing: square root of the area in the plane, m.
    pub(crate) size: Vec<f64>,
    snapshot: Snapshot,
}

/// Smoothing length over spacing where a snapshot has neither area nor spacing.
const SMOOTHING_OVER_SPACING: f64 = 1.3;

impl Body {
    fn read(name: &str, path: &std::path::Path) -> Result<Self, String> {
        let snapshot = Snapshot::read(path)
            .and_then(left)
            .map_err(|e| format!("{e}; this body is missing in the pictures."))?;
        let position: Vec<[f64; 2]> = snapshot.points.iter().map(|p| [p[0], p[1]]).collect();
        let size = sizes(&snapshot).ok_or_else(|| {
            format!(
                "{} has none of area, spacing and smoothing_length; this body is not drawn.",
                path.display()
            )
        })?;
        Ok(Self {
            name: name.to_string(),
            position,
            size,
            snapshot,
        })
    }

    /// A scalar field.
    pub(crate) fn field(&self, name: &str) -> Option<&[f64]> {
        self.snapshot
            .field(name)
            .filter(|field| field.components == 1)?;
        self.snapshot.values(name)
    }

    /// One component of a vector or tensor field.
    pub(crate) fn component(&self, name: &str, index: usize) -> Option<Vec<f64>> {
        let components = self.snapshot.field(name)?.components;
        let values = self.snapshot.values(name)?;
        (index < components).then(|| values.chunks_exact(components).map(|v| v[index]).collect())
    }

    /// Solids carry a plastic strain.
    pub(crate) fn is_solid(&self) -> bool {
        self.field("plastic_strain").is_some()
    }
}

/// What has not been removed by failure.
fn left(snapshot: Snapshot) -> Result<Snapshot, OutputError> {
    let Some(removed) = snapshot.values("removed") else {
        return Ok(snapshot);
    };
    if removed.iter().all(|r| *r == 0.0) {
        return Ok(snapshot);
    }
    let kept: Vec<usize> = (0..removed.len()).filter(|&a| removed[a] == 0.0).collect();
    snapshot.select(&kept)
}

fn sizes(snapshot: &Snapshot) -> Option<Vec<f64>> {
    if let Some(spacing) = snapshot.values("spacing") {
        return Some(spacing.to_vec());
    }
    if let Some(area) = snapshot.values("area") {
        return Some(area.iter().map(|a| a.max(0.0).sqrt()).collect());
    }
    let smoothing = snapshot.values("smoothing_length")?;
    Some(
        smoothing
            .iter()
            .map(|h| h / SMOOTHING_OVER_SPACING)
            .collect(),
    )
}
