//! Tracing for the preview: the passes of a picture, the object at a place, the line around an object.

use std::collections::{HashMap, HashSet};
use std::io::Cursor;
use std::time::Instant;

use scenec_device::{DeviceInfo, Precision, suited};
use scenec_picture::{
    Encoding, Format, Frame, Layers, Limits, NOTHING, Picture, Request, TraceError, Watch, Window, encode,
};
use scenec_plan::{Features, Plan};

use super::machine::Machine;
use super::outline::line_around;
use super::passes::{Goal, Grain, UNKNOWN};
use super::processor::{Processor, precision};
use super::words::{Pass, Quality};

/// Of how many scenes the speed is remembered.
const SPEEDS: usize = 64;

/// Traces one job after another; threads and speeds are kept between them.
#[derive(Default)]
pub(super) struct Painter {
    cpu: Option<Processor>,
    /// Nanoseconds a sample on the processor, by the scene's name.
    speeds: HashMap<String, f64>,
}

/// A picture to be drawn.
pub(super) struct Drawing<'a> {
    pub(super) name: &'a str,
    pub(super) plan: &'a Plan,
    pub(super) quality: Quality,
    /// What is to compute.
    pub(super) device: &'a str,
    pub(super) watch: &'a Watch,
    pub(super) begin: Instant,
}

/// A traced pass.
struct Traced {
    frame: Frame,
    device: String,
    /// Nanoseconds a sample.
    speed: f64,
}

impl Painter {
    /// Draws all passes; each goes to `show` as a PNG file. The result tells why another device than the wanted one
    /// drew, if so.
    pub(super) fn draw(
        &mut self,
        drawing: &Drawing<'_>,
        mut show: impl FnMut(Pass, &[u8]),
    ) -> Result<Option<String>, TraceError> {
        let view = &drawing.plan.view;
        let samples = match drawing.quality {
            Quality::Draft => 1,
            Quality::Full => u32::try_from(view.samples.len()).unwrap_or(u32::MAX),
        };
        let goal = Goal {
            width: view.width,
            height: view.height,
            samples,
        };
        self.show(drawing.plan)?;
        let mut machine = Machine::new(drawing.device, precision(drawing.plan));
        let mut speed = self.speeds.get(drawing.name).copied().unwrap_or(UNKNOWN);
        let mut done = None;
        for pass in 0.. {
            let Some(grain) = goal.next(done, speed) else {
                break;
            };
            let traced = match machine.for_pass(grain.divisor == 1, goal.nanoseconds(grain, speed)) {
                Some((info, precision)) => match on_device((info, precision), drawing, &goal, grain) {
                    Err(TraceError::Failed(why)) if !drawing.watch.stopped() => {
                        machine.give_up(info, &why);
                        self.on_cpu(drawing, &goal, grain)?
                    }
                    outcome => outcome?,
                },
                None => self.on_cpu(drawing, &goal, grain)?,
            };
            (speed, done) = (traced.speed, Some(grain));
            let (width, height) = goal.size(grain);
            let png = png(&traced.frame.picture)?;
            let told = Pass {
                pass,
                last: grain == goal.last(),
                width,
                height,
                device: traced.device,
                milliseconds: drawing.begin.elapsed().as_secs_f64() * 1e3,
            };
            show(told, &png);
        }
        Ok(machine.remark)
    }

    /// The solid that a place of the picture shows; 0 to 1 from the upper left corner.
    pub(super) fn pick(&mut self, plan: &Plan, (x, y): (f64, f64), watch: &Watch) -> Result<Option<u32>, TraceError> {
        // A cast from a float ends at the bounds of the integer, and turns what is no number into 0.
        let pixel = |part: f64, count: u32| ((part * f64::from(count)) as u32).min(count.saturating_sub(1));
        let window = Window {
            x: pixel(x, plan.view.width),
            y: pixel(y, plan.view.height),
            width: 1,
            height: 1,
        };
        let ids = self.ids(plan, window, watch)?;
        Ok(ids.first().copied().filter(|id| *id != NOTHING))
    }

    /// A see-through picture of a line around what shows of the leaves; empty if nothing does.
    pub(super) fn outline(&mut self, plan: &Plan, leaves: &HashSet<u32>, watch: &Watch) -> Result<Vec<u8>, TraceError> {
        if leaves.is_empty() {
            return Ok(Vec::new());
        }
        let (width, height) = (plan.view.width, plan.view.height);
        let ids = self.ids(plan, Window::whole(width, height), watch)?;
        let shown: Vec<bool> = ids.iter().map(|id| leaves.contains(id)).collect();
        if !shown.contains(&true) {
            return Ok(Vec::new());
        }
        let line = line_around(width as usize, &shown);
        scenec_picture::overlay(width, height, &line).map_err(|error| TraceError::Failed(error.to_string()))
    }

    fn ids(&mut self, plan: &Plan, window: Window, watch: &Watch) -> Result<Vec<u32>, TraceError> {
        let cpu = self.show(plan)?;
        cpu.divide((plan.view.width, plan.view.height), &[[0.0; 2]]);
        let layers = Layers {
            ids: true,
            ..Layers::default()
        };
        let frame = cpu.trace(&request(window, layers, watch))?;
        Ok(frame.ids.unwrap_or_default())
    }

    fn show(&mut self, plan: &Plan) -> Result<&mut Processor, TraceError> {
        let cpu = Processor::show(self.cpu.take(), plan)?;
        Ok(self.cpu.insert(cpu))
    }

    fn on_cpu(&mut self, drawing: &Drawing<'_>, goal: &Goal, grain: Grain) -> Result<Traced, TraceError> {
        let Some(cpu) = &mut self.cpu else {
            return Err(TraceError::Failed("no tracer".to_owned()));
        };
        let (width, height) = goal.size(grain);
        let points = drawing
            .plan
            .view
            .samples
            .get(..grain.samples as usize)
            .unwrap_or_default();
        cpu.divide((width, height), points);
        let begin = Instant::now();
        let frame = cpu.trace(&request(Window::whole(width, height), Layers::default(), drawing.watch))?;
        let speed = begin.elapsed().as_secs_f64() * 1e9 / goal.nanoseconds(grain, 1.0);
        if self.speeds.len() >= SPEEDS {
            self.speeds.clear();
        }
        self.speeds.insert(drawing.name.to_owned(), speed);
        Ok(Traced {
            frame,
            device: cpu.name(),
            speed,
        })
    }
}

/// A pass of the full size on an OpenCL device.
fn on_device(
    (info, precision): (&DeviceInfo, Precision),
    drawing: &Drawing<'_>,
    goal: &Goal,
    grain: Grain,
) -> Result<Traced, TraceError> {
    let begin = Instant::now();
    let mut plan = drawing.plan.clone();
    plan.view.samples.truncate(grain.samples as usize);
    let mut tracer = scenec_device::tracer(info, &plan, precision, &suited(info, Features::of(&plan)))
        .map_err(|error| TraceError::Failed(error.to_string()))?;
    if drawing.watch.stopped() {
        return Err(TraceError::Cancelled);
    }
    let frame = tracer.trace(&request(
        Window::whole(goal.width, goal.height),
        Layers::default(),
        drawing.watch,
    ))?;
    Ok(Traced {
        frame,
        device: tracer.name(),
        speed: begin.elapsed().as_secs_f64() * 1e9 / goal.nanoseconds(grain, 1.0),
    })
}

fn request(window: Window, layers: Layers, watch: &Watch) -> Request<'_> {
    Request {
        window,
        limits: Limits::DEFAULT,
        layers,
        watch,
    }
}

fn png(picture: &Picture) -> Result<Vec<u8>, TraceError> {
    let format = Format::from_name("png").ok_or_else(|| TraceError::Failed("no PNG".to_owned()))?;
    let mut bytes = Cursor::new(Vec::new());
    encode(picture, &Encoding::of(format), &mut bytes).map_err(|error| TraceError::Failed(error.to_string()))?;
    Ok(bytes.into_inner())
}
