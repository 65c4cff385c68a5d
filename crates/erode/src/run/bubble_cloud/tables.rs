//! What a run of a cloud writes: tables, paths of the followed bubbles, snapshots, the map of the wall.

use super::rows;
use crate::case::cloud::BubbleCloud;
use crate::output::{
    Collection, Column, Data, Encoding, Entry, Field, RunPaths, Snapshot, TableWriter,
};
use crate::run::RunError;
use erode_fv::bubbles::{Cloud, Totals};
use erode_physics::erosion::PotentialMap;
use serde_json::{Map, Value};
use std::path::Path;

/// The open files of a run.
pub(super) struct Tables {
    history: TableWriter,
    pub(super) collapses: TableWriter,
    paths: Vec<TableWriter>,
    fields: Collection,
    places: RunPaths,
    snapshots: u64,
}

fn columns(list: &[(&str, &str)]) -> Vec<Column> {
    list.iter()
        .map(|(name, unit)| Column::new(*name, *unit))
        .collect()
}

impl Tables {
    /// New files, or old ones as they were when `marks` was taken.
    pub(super) fn open(
        paths: &RunPaths,
        case: &BubbleCloud,
        marks: Option<&Value>,
    ) -> Result<Self, RunError> {
        let open = |path: &Path, list: &[(&str, &str)], key: &str| match marks {
            Some(m) => {
                TableWriter::resume(path, &columns(list), m["rows"][key].as_u64().unwrap_or(0))
            }
            None => TableWriter::create(path, &columns(list)),
        };
        let followed = case.followed.min(case.count);
        let of_bubble = |i: u64| open(&paths.probe(&name(i)), &rows::PATH, "history");
        let mut fields = Collection::new(paths.collection());
        let snapshots = marks.and_then(|m| m["snapshots"].as_u64()).unwrap_or(0);
        if let Some(time) = marks.and_then(|m| m["time"].as_f64())
            && paths.collection().exists()
        {
            fields = Collection::read(&paths.collection())?;
            fields.truncate(time)?;
        }
        Ok(Self {
            history: open(&paths.history(), &rows::HISTORY, "history")?,
            collapses: open(&paths.collapses(), &rows::COLLAPSES, "collapses")?,
            paths: (0..followed).map(of_bubble).collect::<Result<_, _>>()?,
            fields,
            places: paths.clone(),
            snapshots,
        })
    }

    /// One row in `history.csv` and in the path of every followed bubble.
    pub(super) fn write_row(&mut self, cloud: &Cloud, totals: &Totals) -> Result<(), RunError> {
        self.history.write_row(&rows::history(cloud, totals))?;
        for (bubble, table) in self.paths.iter_mut().enumerate() {
            table.write_row(&rows::path(cloud, bubble as u64))?;
        }
        Ok(())
    }

    /// A snapshot of all bubbles.
    pub(super) fn write_fields(&mut self, cloud: &Cloud) -> Result<(), RunError> {
        let scalar = |values: Vec<f64>| Data::F64(values);
        let radii = cloud.state.iter().map(|s| s.radius).collect();
        let rates = cloud.state.iter().map(|s| s.wall_velocity).collect();
        let numbers = cloud
            .bubble
            .iter()
            .map(|&b| i64::try_from(b).unwrap_or(i64::MAX));
        let snapshot = Snapshot::new(cloud.time, &cloud.position)
            .with(Field::scalar("bubble", "-", Data::I64(numbers.collect())))
            .with(Field::scalar("bubble_radius", "m", scalar(radii)))
            .with(Field::scalar("wall_velocity", "m/s", scalar(rates)))
            .with(Field::vector("velocity", "m/s", &cloud.velocity));
        let path = self.places.snapshot("bubbles", self.snapshots);
        snapshot.write(&path, Encoding::Zlib)?;
        let file = path.file_name().unwrap_or_default().to_string_lossy();
        self.fields.add(vec![Entry {
            time: cloud.time,
            part: 0,
            name: "bubbles".into(),
            file: format!("fields/{file}"),
        }])?;
        self.snapshots += 1;
        Ok(())
    }

    /// Brings the tables to the disk; tells how long they are, for a checkpoint.
    pub(super) fn mark(&mut self) -> Result<Map<String, Value>, RunError> {
        self.history.sync()?;
        self.collapses.sync()?;
        for path in &mut self.paths {
            path.sync()?;
        }
        let mut rows = Map::new();
        rows.insert("history".into(), self.history.rows().into());
        rows.insert("collapses".into(), self.collapses.rows().into());
        let mut marks = Map::new();
        marks.insert("rows".into(), rows.into());
        marks.insert("snapshots".into(), self.snapshots.into());
        marks.insert(
            "time".into(),
            self.fields.entries().last().map(|e| e.time).into(),
        );
        Ok(marks)
    }
}

/// Name of the table of a followed bubble.
fn name(bubble: u64) -> String {
    format!("bubble_{bubble}")
}

const MAP: [(&str, &str); 6] = [
    ("wall_x", "m"),
    ("wall_y", "m"),
    ("area", "m2"),
    ("impacts", "-"),
    ("erosion_potential", "-"),
    ("erosion_potential_squared", "-"),
];

/// The map of the wall; NaN shares before the first impact.
pub(super) fn write_map(path: &Path, map: &PotentialMap) -> Result<(), RunError> {
    let mut table = TableWriter::create(path, &columns(&MAP))?;
    let (linear, squared) = (map.linear(), map.squared());
    let share = |shares: &Option<Vec<f64>>, k: usize| shares.as_ref().map_or(f64::NAN, |s| s[k]);
    for (k, element) in map.elements().iter().enumerate() {
        #[allow(clippy::cast_precision_loss)] // a count
        let impacts = map.impacts()[k] as f64;
        let [x, y, _] = element.centre;
        table.write_row(&[
            x,
            y,
            element.area,
            impacts,
            share(&linear, k),
            share(&squared, k),
        ])?;
    }
    Ok(table.sync()?)
}
