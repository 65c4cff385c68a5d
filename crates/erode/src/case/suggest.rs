//! "Did you mean": the closest of the allowed words.

/// The candidate that is closest to `word`, if it is close enough to be meant.
pub(crate) fn closest<'a>(
    word: &str,
    candidates: impl Iterator<Item = &'a str>,
) -> Option<&'a str> {
    let lower = word.to_lowercase();
    let length = word.chars().count();
    let mut best: Option<((usize, usize), &str)> = None;
    for candidate in candidates {
        let distance = strsim::damerau_levenshtein(&lower, &candidate.to_lowercase());
        let other = candidate.chars().count();
        // Of equally near words one of the same length is meant rather than a shorter or longer one.
        let rank = (distance, other.abs_diff(length));
        if distance <= 1 + other.max(length) / 4 && best.is_none_or(|(r, _)| rank < r) {
            best = Some((rank, candidate));
        }
    }
    best.map(|(_, c)| c)
}

/// "did you mean `x`? Allowed: a, b, c", or the list alone.
pub(crate) fn did_you_mean<'a>(
    word: &str,
    allowed: impl Iterator<Item = &'a str> + Clone,
    what: &str,
) -> String {
    let list = allowed.clone().collect::<Vec<_>>().join(", ");
    let list = if list.is_empty() {
        "none".to_owned()
    } else {
        list
    };
    match closest(word, allowed) {
        Some(c) => format!("did you mean `{c}`? {what}: {list}"),
        None => format!("{what}: {list}"),
    }
}

#[cfg(test)]
mod tests {
    use super::closest;

    #[test]
    fn near_words_are_found_and_far_ones_are_not() {
        let words = ["particles_per_radius", "standoff", "radius"];
        let find = |w: &str| closest(w, words.iter().copied());
        assert_eq!(find("particle_per_radius"), Some("particles_per_radius"));
        assert_eq!(find("stand_off"), Some("standoff"));
        assert_eq!(find("Radius"), Some("radius"));
        assert_eq!(find("temperature"), None);
        assert_eq!(closest("mn", ["m", "mm"].into_iter()), Some("mm"));
    }
}
