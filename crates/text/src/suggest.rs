//! "Did you mean": the nearest name in a name space.

/// The candidate nearest to `name` by edit distance with swapped neighbours (Damerau 1964), if it is near enough to be
/// a slip of the finger: at most a third of the longer word may differ. Ties go to the first candidate.
#[must_use]
pub fn closest<'a>(name: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    // A name this long is no slip, and the distance costs the product of both lengths.
    const LONGEST: usize = 64;
    if name.len() > LONGEST {
        return None;
    }
    let mut best: Option<(usize, &str)> = None;
    for candidate in candidates {
        let longer = name.chars().count().max(candidate.chars().count());
        if candidate == name || candidate.len() > LONGEST {
            continue;
        }
        let distance = if candidate.eq_ignore_ascii_case(name) {
            0
        } else {
            strsim::osa_distance(name, candidate)
        };
        if distance * 3 <= longer && best.is_none_or(|(least, _)| distance < least) {
            best = Some((distance, candidate));
        }
    }
    best.map(|(_, candidate)| candidate)
}

#[cfg(test)]
mod tests {
    use super::closest;

    fn check(name: &str, expect: Option<&str>) {
        let names = ["sphere", "base", "red", "width", "height"];
        assert_eq!(closest(name, names), expect, "{name}");
    }

    #[test]
    fn near_names_are_offered_and_far_ones_are_not() {
        check("shpere", Some("sphere"));
        check("Red", Some("red"));
        check("widht", Some("width"));
        check("green", None);
        check("b", None);
        check(&"sphere".repeat(100), None);
    }
}
