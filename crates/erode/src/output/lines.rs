//! What differs between two texts, line by line.

/// Lines that only the old text has (`-`) and that only the new one has (`+`), in order; at most `most` of them, and a
/// line that says how many more there are.
pub(crate) fn difference(old: &str, new: &str, most: usize) -> Vec<String> {
    let (a, b): (Vec<&str>, Vec<&str>) = (old.lines().collect(), new.lines().collect());
    let longest = longest_common(&a, &b);
    let (mut i, mut j) = (0, 0);
    let mut all = Vec::new();
    while i < a.len() || j < b.len() {
        if i < a.len() && j < b.len() && a[i] == b[j] {
            (i, j) = (i + 1, j + 1);
        } else if j == b.len() || (i < a.len() && longest[i + 1][j] >= longest[i][j + 1]) {
            all.push(format!("- {}", a[i]));
            i += 1;
        } else {
            all.push(format!("+ {}", b[j]));
            j += 1;
        }
    }
    let more = all.len().saturating_sub(most);
    all.truncate(most);
    if more > 0 {
        all.push(format!("(and {more} more lines)"));
    }
    all
}

/// `[i][j]`: length of the longest common subsequence of what follows line i of `a` and line j of `b`.
fn longest_common(a: &[&str], b: &[&str]) -> Vec<Vec<usize>> {
    let mut length = vec![vec![0; b.len() + 1]; a.len() + 1];
    for i in (0..a.len()).rev() {
        for j in (0..b.len()).rev() {
            length[i][j] = if a[i] == b[j] {
                length[i + 1][j + 1] + 1
            } else {
                length[i + 1][j].max(length[i][j + 1])
            };
        }
    }
    length
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_differs_is_told() {
        let difference = |a, b| difference(a, b, 9);
        assert_eq!(difference("a\nb\nc", "a\nx\nc"), ["- b", "+ x"]);
        assert_eq!(difference("a\nb", "a\nb\nc"), ["+ c"]);
        assert_eq!(difference("a\nb", "b"), ["- a"]);
        assert!(difference("a\nb", "a\nb").is_empty());
    }

    #[test]
    fn a_long_difference_is_cut_and_counted() {
        let old: String = (0..20).map(|k| format!("{k}\n")).collect();
        let told = difference(&old, "", 5);
        assert_eq!(told.len(), 6);
        assert_eq!(told[5], "(and 15 more lines)");
    }
}
