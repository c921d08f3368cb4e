//! Single pixels, one to a thread at a time: slow enough for that.

use scenec_picture::{Limits, Refined, Refiner, SIDES, Sampled, Stats, Task, TraceError, Watch, Window};

use crate::camera::Eye;
use crate::reference::Reference;
use crate::tally::Tally;

impl Refiner for Reference {
    fn refine(
        &mut self,
        window: Window,
        limits: Limits,
        task: &Task<'_>,
        watch: &Watch,
    ) -> Result<(Vec<Refined>, Stats), TraceError> {
        let eye = self.eye()?;
        let mut refined = vec![Refined::default(); task.pixels.len()];
        let pieces = task.pixels.iter().zip(&mut refined).enumerate();
        let stats = self.share(pieces, watch, |(number, (pixel, refined))| {
            let columns = window.width.max(1);
            let place = [window.x + pixel % columns, window.y + pixel / columns];
            let mut tally = Tally::new(limits.ray_budget.max(1));
            let mut sampled = Sampled::default();
            for [x, y] in SIDES.into_iter().filter(|_| task.sides) {
                sampled.see(self.look(eye, place, [0.5 + x, 0.5 + y], &mut tally).colour.to_array());
            }
            let enough = |sampled: &Sampled| (task.enough)(number, sampled) || watch.stopped();
            *refined = self.refined(eye, place, sampled, &mut tally, &enough);
            Stats {
                dropped: refined.spread.dropped.into(),
                ..tally.stats(1)
            }
        });
        if watch.stopped() {
            return Err(TraceError::Cancelled);
        }
        Ok((refined, stats))
    }
}

impl Reference {
    fn refined(
        &self,
        eye: &Eye,
        place: [u32; 2],
        mut sampled: Sampled,
        tally: &mut Tally,
        enough: &dyn Fn(&Sampled) -> bool,
    ) -> Refined {
        let mut dropped = tally.stats(1).dropped;
        for k in 0..self.samples {
            if tally.is_spent() {
                break;
            }
            let sight = self.sample(eye, place, k, tally);
            let so_far = tally.stats(1).dropped;
            sampled.add(sight.colour.to_array(), so_far - dropped);
            dropped = so_far;
            if sampled.is_stop() && enough(&sampled) {
                break;
            }
        }
        Refined::from(&sampled)
    }
}
