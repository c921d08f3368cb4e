//! The diagram of work and precision: time and error of each row, both logarithmic, a curve for each family.
//!
//! The letters are of a font in this crate, so that a diagram needs no font of the machine and looks the same on all.

use std::ops::Range;
use std::sync::OnceLock;

use plotters::coord::Shift;
use plotters::coord::combinators::LogCoord;
use plotters::prelude::*;
use plotters::style::register_font;
use scenec_picture::{Picture, TooManyPixels};

use crate::run::{Report, Row};

const SIZE: (u32, u32) = (1200, 800);
const FONT: &[u8] = include_bytes!("../font/DejaVuSans-ASCII.ttf");
/// Errors below this are drawn as this: a logarithm knows no zero.
const FLOOR: f64 = 1e-9;
/// Colours that stay apart for most eyes and on paper (Okabe and Ito 2008).
const COLOURS: [RGBColor; 8] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(86, 180, 233),
    RGBColor(230, 159, 0),
    RGBColor(90, 90, 90),
    RGBColor(140, 86, 75),
];

type Chart<'a, B> = ChartContext<'a, B, Cartesian2d<LogCoord<f64>, LogCoord<f64>>>;

/// The diagram as a drawing.
///
/// # Errors
/// A sentence, if it can't be drawn.
pub fn svg(name: &str, report: &Report) -> Result<String, String> {
    let mut text = String::new();
    let area = SVGBackend::with_string(&mut text, SIZE).into_drawing_area();
    draw(&area, name, report)?;
    drop(area);
    Ok(text)
}

/// The diagram as a picture.
///
/// # Errors
/// A sentence, if it can't be drawn.
pub fn png(name: &str, report: &Report) -> Result<Picture, String> {
    let (width, height) = SIZE;
    let mut bytes = vec![0; width as usize * height as usize * 3];
    let area = BitMapBackend::with_buffer(&mut bytes, SIZE).into_drawing_area();
    draw(&area, name, report)?;
    drop(area);
    let mut picture = Picture::black(width, height).map_err(|error: TooManyPixels| error.to_string())?;
    let (pixels, _) = bytes.as_chunks::<3>();
    for (pixel, levels) in picture.pixels_mut().iter_mut().zip(pixels) {
        *pixel = levels.map(|level| f32::from(level) / 255.0);
    }
    Ok(picture)
}

fn draw<B: DrawingBackend>(area: &DrawingArea<B, Shift>, name: &str, report: &Report) -> Result<(), String> {
    static READY: OnceLock<bool> = OnceLock::new();
    if !*READY.get_or_init(|| register_font("sans-serif", FontStyle::Normal, FONT).is_ok()) {
        return Err("the letters of the diagram can't be read".to_owned());
    }
    plot(area, name, report).map_err(|error| format!("the diagram can't be drawn: {error}"))
}

fn plot<B: DrawingBackend>(
    area: &DrawingArea<B, Shift>,
    name: &str,
    report: &Report,
) -> Result<(), DrawingAreaErrorKind<B::ErrorType>> {
    area.fill(&WHITE)?;
    let (times, errors) = ranges(report);
    let mut chart = ChartBuilder::on(area)
        .caption(format!("{name}: error against run time"), ("sans-serif", 24))
        .margin(16)
        .x_label_area_size(48)
        .y_label_area_size(80)
        .build_cartesian_2d(times.clone().log_scale(), errors.log_scale())?;
    chart
        .configure_mesh()
        .x_desc("kernel time, ms")
        .y_desc("error: root mean square from the reference")
        .label_style(("sans-serif", 15))
        .axis_desc_style(("sans-serif", 17))
        .x_label_formatter(&|time| format!("{time}"))
        .y_label_formatter(&|error| format!("{error:.0e}"))
        .light_line_style(RGBColor(240, 240, 240))
        .draw()?;
    for (level, words) in [(1.0 / 255.0, "1/255"), (1.0 / 510.0, "1/510")] {
        let line = [(times.start, level), (times.end, level)];
        chart.draw_series(LineSeries::new(line, RGBColor(150, 150, 150)))?;
        let place = (times.start * 1.05, level * 1.08);
        let style = ("sans-serif", 14).into_font().color(&RGBColor(110, 110, 110));
        chart.draw_series([Text::new(words, place, style)])?;
    }
    front(&mut chart, report)?;
    for (index, family) in families(report).into_iter().enumerate() {
        curve(&mut chart, report, family, COLOURS[index % COLOURS.len()])?;
    }
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::UpperRight)
        .background_style(WHITE.mix(0.9))
        .border_style(RGBColor(180, 180, 180))
        .label_font(("sans-serif", 15))
        .draw()?;
    area.present()
}

/// A family: its rows joined in the order of their times; above each a bar up to its bound, whose end is hollow. Rows
/// that the reference can't judge are hollow too.
fn curve<B: DrawingBackend>(
    chart: &mut Chart<'_, B>,
    report: &Report,
    family: &str,
    colour: RGBColor,
) -> Result<(), DrawingAreaErrorKind<B::ErrorType>> {
    let rows: Vec<&Row> = report.rows.iter().filter(|row| row.family == family).collect();
    let mut line: Vec<_> = rows.iter().map(|row| point(row)).collect();
    line.sort_by(|a, b| a.0.total_cmp(&b.0));
    let stroke = colour.stroke_width(2);
    chart
        .draw_series(LineSeries::new(line, stroke))?
        .label(family)
        .legend(move |(x, y)| PathElement::new([(x, y), (x + 20, y)], stroke));
    for row in rows {
        let (time, error) = point(row);
        let bound = row.bound.rms.max(FLOOR);
        chart.draw_series(LineSeries::new([(time, error), (time, bound)], colour.mix(0.45)))?;
        chart.draw_series([Circle::new((time, bound), 3, colour.mix(0.6))])?;
        let style = ShapeStyle {
            filled: !row.limited,
            ..colour.into()
        };
        chart.draw_series([Circle::new((time, error), 5, style)])?;
    }
    Ok(())
}

/// What nothing beats, joined by a broad pale line.
fn front<B: DrawingBackend>(
    chart: &mut Chart<'_, B>,
    report: &Report,
) -> Result<(), DrawingAreaErrorKind<B::ErrorType>> {
    let mut line: Vec<_> = report.rows.iter().filter(|row| row.front).map(point).collect();
    line.sort_by(|a, b| a.0.total_cmp(&b.0));
    let stroke = RGBColor(250, 220, 120).stroke_width(9);
    chart
        .draw_series(LineSeries::new(line, stroke))?
        .label("nothing is both quicker and better")
        .legend(move |(x, y)| PathElement::new([(x, y), (x + 20, y)], stroke));
    Ok(())
}

/// Milliseconds and error.
fn point(row: &Row) -> (f64, f64) {
    (row.kernel.median * 1e3, row.figures.rmse.max(FLOOR))
}

/// In the order of the table.
fn families(report: &Report) -> Vec<&str> {
    let mut names: Vec<&str> = report.rows.iter().map(|row| row.family.as_str()).collect();
    names.dedup();
    names
}

/// Whole decades that hold everything, 1/255 included.
fn ranges(report: &Report) -> (Range<f64>, Range<f64>) {
    let times = report.rows.iter().map(|row| point(row).0);
    let errors = report
        .rows
        .iter()
        .flat_map(|row| [point(row).1, row.bound.rms.max(FLOOR)]);
    (decades(times), decades(errors.chain([1.0 / 510.0, 1.0 / 255.0])))
}

fn decades(values: impl Iterator<Item = f64>) -> Range<f64> {
    let ends = values.filter(|value| value.is_finite() && *value > 0.0);
    let (low, high) = ends.fold((f64::INFINITY, 0.0_f64), |(low, high), value| {
        (low.min(value), high.max(value))
    });
    if low > high {
        return 1.0..10.0;
    }
    let start = low.log10().floor();
    10_f64.powf(start)..10_f64.powf((high.log10().ceil()).max(start + 1.0))
}

#[cfg(test)]
mod tests {
    use super::decades;

    fn check(values: &[f64], start: f64, end: f64) {
        let range = decades(values.iter().copied());
        assert!((range.start / start - 1.0).abs() < 1e-12, "{range:?}");
        assert!((range.end / end - 1.0).abs() < 1e-12, "{range:?}");
    }

    #[test]
    fn axes_are_of_whole_decades() {
        check(&[], 1.0, 10.0);
        check(&[3.0], 1.0, 10.0);
        check(&[0.02, 5.0, f64::INFINITY, f64::NAN, 0.0], 0.01, 10.0);
        check(&[1.0], 1.0, 10.0);
    }
}
