//! `resolved.toml`: the simulation as a case, with every default written out.

use super::{
    keys::CASE,
    resolved_items::case_items,
    schema::{Kind, Table},
    simulation::Simulation,
};

/// Something to write.
pub(crate) enum Item {
    Number(f64),
    Whole(u64),
    Text(String),
    Switch(bool),
    Pair([f64; 2]),
    Table(Items),
    List(Vec<Items>),
}

/// Keys with what stands under them, in order.
pub(crate) type Items = Vec<(&'static str, Item)>;

/// The simulation as TOML; reading it gives the same simulation.
pub(crate) fn write(simulation: &Simulation) -> String {
    let mut out =
        String::from("# The case with every default written out, in SI. It can itself be run.\n");
    write_items(&mut out, "", &case_items(simulation), &CASE);
    out
}

/// Values first, then tables: TOML wants that order.
fn write_items(out: &mut String, path: &str, items: &Items, schema: &'static Table) {
    for (key, item) in items {
        if let Some(value) = value(item) {
            out.push_str(&format!("{key} = {value}{}\n", comment(key, schema)));
        }
    }
    for (key, item) in items {
        let inner = if path.is_empty() {
            (*key).to_owned()
        } else {
            format!("{path}.{key}")
        };
        match (item, schema.key(key).map(|k| k.kind)) {
            (Item::Table(items), Some(Kind::Table(schema))) => {
                // A table with values needs its header, and so does one that is empty: it is a choice.
                if items.is_empty() || items.iter().any(|(_, i)| value(i).is_some()) {
                    out.push_str(&format!("\n[{inner}]\n"));
                }
                write_items(out, &inner, items, schema);
            }
            (Item::List(list), Some(Kind::List(schema))) => {
                for items in list {
                    out.push_str(&format!("\n[[{inner}]]\n"));
                    write_items(out, &inner, items, schema);
                }
            }
            _ => {}
        }
    }
}

fn value(item: &Item) -> Option<String> {
    Some(match item {
        // Debug prints the shortest digits that read back as the same number.
        Item::Number(x) => format!("{x:?}"),
        Item::Whole(n) => n.to_string(),
        Item::Text(s) => toml::Value::String(s.clone()).to_string(),
        Item::Switch(b) => b.to_string(),
        Item::Pair([a, b]) => format!("[{a:?}, {b:?}]"),
        Item::Table(_) | Item::List(_) => return None,
    })
}

/// Unit and meaning.
fn comment(key: &str, schema: &'static Table) -> String {
    let Some(key) = schema.key(key) else {
        return String::new();
    };
    match key.kind {
        Kind::Quantity(d, _) | Kind::Property(d, _) | Kind::Pair(d)
            if d != super::units::NUMBER =>
        {
            format!("  # {d}: {}", key.about)
        }
        _ => format!("  # {}", key.about),
    }
}
