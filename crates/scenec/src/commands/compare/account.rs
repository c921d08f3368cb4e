//! The figures in words, or as JSON.

use std::io::{self, Write};

use clap::ValueEnum;
use scenec_picture::Figures;
use serde_json::json;

use super::Figure;
use crate::report::{plural, sanitise};

/// How figures are written.
#[derive(ValueEnum, Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Form {
    /// For people, a line a figure
    Text,
    /// One JSON object
    Json,
}

/// What was found.
pub(super) struct Account {
    pub(super) names: [String; 2],
    pub(super) size: (u32, u32),
    pub(super) figures: Figures,
    /// The mean of FLIP, and how near the screen was taken to be.
    pub(super) flip: f64,
    pub(super) pixels_per_degree: f64,
    /// The figure that is above its limit, and the limit.
    pub(super) over: Option<(Figure, f64)>,
}

impl Account {
    /// # Errors
    /// Those of `out`.
    pub(super) fn write(&self, form: Form, out: &mut dyn Write) -> io::Result<()> {
        match form {
            Form::Text => self.text(out),
            Form::Json => writeln!(out, "{:#}", self.json()),
        }
    }

    fn text(&self, out: &mut dyn Write) -> io::Result<()> {
        let [first, second] = self.names.each_ref().map(|name| sanitise(name));
        let figures = &self.figures;
        writeln!(out, "{first} against {second}: {} x {}", self.size.0, self.size.1)?;
        writeln!(out, "rmse        {:.3e}", figures.rmse)?;
        writeln!(out, "max         {:.3e}", figures.max_abs)?;
        writeln!(out, "p99         {:.3e}", figures.p99_abs)?;
        let share = figures.off_share * 100.0;
        writeln!(out, "share       {share:.3} % of the pixels are off by more than 1/255")?;
        let near = self.pixels_per_degree;
        writeln!(
            out,
            "flip        {:.3e} on average, at {near} pixels a degree",
            self.flip
        )?;
        let strange = usize::try_from(figures.non_finite).unwrap_or(usize::MAX);
        writeln!(out, "non-finite  {}", plural(strange, "pixel"))?;
        match self.over {
            Some(_) if strange > 0 => writeln!(out, "above the limit: pixels that are not finite have no difference"),
            Some((figure, limit)) => writeln!(
                out,
                "above the limit: {} is {:.3e}, and {limit:.3e} is allowed",
                name(figure),
                figure.of(figures, self.flip)
            ),
            None => Ok(()),
        }
    }

    fn json(&self) -> serde_json::Value {
        let figures = &self.figures;
        json!({
            "first": self.names[0],
            "second": self.names[1],
            "width": self.size.0,
            "height": self.size.1,
            "rmse": figures.rmse,
            "max": figures.max_abs,
            "p99": figures.p99_abs,
            "share": figures.off_share,
            "flip": self.flip,
            "pixels_per_degree": self.pixels_per_degree,
            "non_finite": figures.non_finite,
            "over": self.over.map(|(figure, limit)| json!({"figure": name(figure), "limit": limit})),
        })
    }
}

/// What the command line calls it.
fn name(figure: Figure) -> String {
    figure
        .to_possible_value()
        .map_or_else(String::new, |value| value.get_name().to_owned())
}
