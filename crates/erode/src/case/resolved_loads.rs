//! Loads under the keys of a case file.

use super::{
    loads::{Indenter, Loads, Pressure, Ramp},
    resolved::{Item, Items},
};

/// `[indenter]`, `[[pressure]]` and `[settling]`.
pub(crate) fn load_items(loads: &Loads) -> Items {
    let mut items: Items = Vec::new();
    items.extend(
        loads
            .indenter
            .as_ref()
            .map(|i| ("indenter", Item::Table(indenter_items(i)))),
    );
    if !loads.pressures.is_empty() {
        let list = loads.pressures.iter().map(pressure_items).collect();
        items.push(("pressure", Item::List(list)));
    }
    items.extend(loads.settling.map(|s| {
        let table = vec![
            ("start", Item::Number(s.start)),
            ("damping", Item::Number(s.damping)),
        ];
        ("settling", Item::Table(table))
    }));
    items
}

fn indenter_items(i: &Indenter) -> Items {
    vec![
        ("body", Item::Text(i.body.clone())),
        ("radius", Item::Number(i.radius)),
        ("depth", Item::Number(i.depth)),
        ("centre", Item::Number(i.centre)),
        ("ramp", Item::Table(ramp_items(i.ramp))),
    ]
}

fn pressure_items(p: &Pressure) -> Items {
    let mut items = vec![
        ("body", Item::Text(p.body.clone())),
        ("amplitude", Item::Number(p.gaussian.amplitude)),
        ("diameter", Item::Number(p.gaussian.diameter)),
        ("centre", Item::Number(p.centre)),
    ];
    items.extend(p.ramp.map(|r| ("ramp", Item::Table(ramp_items(r)))));
    items.extend(p.gaussian.pulse.map(|pulse| {
        let table = vec![
            ("peak_time", Item::Number(pulse.peak_time)),
            ("rise_time", Item::Number(pulse.rise_time)),
        ];
        ("pulse", Item::Table(table))
    }));
    items
}

fn ramp_items(r: Ramp) -> Items {
    vec![
        ("start", Item::Number(r.start)),
        ("rise", Item::Number(r.rise)),
        ("hold", Item::Number(r.hold)),
        ("fall", Item::Number(r.fall)),
    ]
}
