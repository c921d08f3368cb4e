//! Which settings are worth their time.

/// Of points (time, error): which have no other that is at least as good in both and better in one.
pub(crate) fn front(points: &[(f64, f64)]) -> Vec<bool> {
    let better = |a: &(f64, f64), b: &(f64, f64)| a.0 <= b.0 && a.1 <= b.1 && (a.0 < b.0 || a.1 < b.1);
    let beaten = |point: &(f64, f64)| points.iter().any(|other| better(other, point));
    points.iter().map(|point| !beaten(point)).collect()
}

#[cfg(test)]
mod tests {
    use super::front;

    #[test]
    fn the_front_holds_what_nothing_beats() {
        let points = [(1.0, 4.0), (2.0, 2.0), (2.0, 3.0), (3.0, 2.0), (4.0, 1.0), (1.0, 4.0)];
        assert_eq!(front(&points), [true, true, false, false, true, true]);
        assert!(front(&[]).is_empty());
    }
}
