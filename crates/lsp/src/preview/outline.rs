//! The line around a part of a picture.

/// Just inside the edge, and just outside of it: one of them shows on any ground.
const INSIDE: [u8; 4] = [255, 176, 0, 255];
const OUTSIDE: [u8; 4] = [0, 0, 0, 160];
const CLEAR: [u8; 4] = [0; 4];

/// A line two pixels wide along the edge of what is `shown`, row by row; clear elsewhere. Where the part runs out of the
/// picture the line follows the border.
pub(super) fn line_around(width: usize, shown: &[bool]) -> Vec<[u8; 4]> {
    let columns = isize::try_from(width).unwrap_or(isize::MAX).max(1);
    let rows = isize::try_from(shown.len()).unwrap_or(isize::MAX) / columns;
    let at = |x: isize, y: isize| {
        let inside = (0..columns).contains(&x) && (0..rows).contains(&y);
        inside && usize::try_from(y * columns + x).is_ok_and(|index| shown.get(index) == Some(&true))
    };
    let around = |x: isize, y: isize| (-1..=1).flat_map(move |dy| (-1..=1).map(move |dx| (x + dx, y + dy)));
    let places = (0..rows).flat_map(|y| (0..columns).map(move |x| (x, y)));
    places
        .map(|(x, y)| match at(x, y) {
            true if !around(x, y).all(|(x, y)| at(x, y)) => INSIDE,
            false if around(x, y).any(|(x, y)| at(x, y)) => OUTSIDE,
            _ => CLEAR,
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::{CLEAR, INSIDE, line_around};

    /// `#` is shown; in what is expected, `i` and `o` are the two sides of the line.
    fn check(picture: &[&str], expect: &[&str]) {
        let width = picture[0].len();
        let shown: Vec<bool> = picture.concat().chars().map(|c| c == '#').collect();
        let letter = |pixel: &[u8; 4]| match *pixel {
            INSIDE => 'i',
            CLEAR => '.',
            _ => 'o',
        };
        let got: String = line_around(width, &shown).iter().map(letter).collect();
        assert_eq!(got, expect.concat());
    }

    #[test]
    fn the_line_lies_on_both_sides_of_the_edge() {
        check(
            &["......", ".####.", ".####.", ".####.", "......"],
            &["oooooo", "oiiiio", "oi..io", "oiiiio", "oooooo"],
        );
        check(
            &[".......", ".......", "...#...", ".......", "......."],
            &[".......", "..ooo..", "..oio..", "..ooo..", "......."],
        );
        check(&["###", "###", "###"], &["iii", "i.i", "iii"]);
        check(&["...", "..."], &["...", "..."]);
    }
}
