//! `scenec devices`

use std::io::{self, Write};
use std::thread;

use clap::Args;
use scenec_device::{DeviceInfo, Discovery, discover, gpu};

use crate::exit::Exit;
use crate::report;

/// List what can render: the OpenCL devices of this machine and the built-in tracers
///
/// The first column is what `scenec render --device` takes.
#[derive(Args, Debug)]
pub(crate) struct Devices {}

impl Devices {
    pub(crate) fn run(&self) -> Exit {
        let threads = thread::available_parallelism().map_or(1, usize::from);
        let text = listing(discover(), threads);
        let mut out = io::stdout().lock();
        match report::remark(&mut out, text.trim_end()).and_then(|()| out.flush()) {
            Ok(()) => Exit::Clean,
            Err(error) => {
                let message = format!("cannot write <stdout>: {error}");
                // With standard error gone too there is nobody left to tell.
                report::failure(&mut io::stderr().lock(), &message).unwrap_or_default();
                Exit::Unusable
            }
        }
    }
}

const COLUMNS: usize = 8;
type Row = [String; COLUMNS];

fn listing(found: &Discovery, threads: usize) -> String {
    let head = [
        "DEVICE", "KIND", "NAME", "PLATFORM", "VERSION", "DRIVER", "MEMORY", "F64",
    ];
    let mut rows = vec![head.map(str::to_owned)];
    rows.extend(["cpu", "reference"].map(|name| built_in(name, threads)));
    rows.extend(found.devices.iter().map(opencl));

    let widths: [usize; COLUMNS] =
        std::array::from_fn(|column| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0));
    let mut text = String::new();
    for row in rows {
        let cells = row.iter().zip(widths).map(|(cell, width)| format!("{cell:<width$}"));
        text.push_str(cells.collect::<Vec<_>>().join("  ").trim_end());
        text.push('\n');
    }
    text.push('\n');
    for note in &found.notes {
        text.push_str(&format!("note: {note}\n"));
    }
    let best = gpu(found).map_or("cpu".to_owned(), |info| {
        format!("{} for long work, cpu otherwise", request(info))
    });
    text.push_str(&format!("--device auto takes {best}\n"));
    text
}

/// What asks for this device.
fn request(info: &DeviceInfo) -> String {
    format!("opencl:{}", info.index)
}

fn built_in(name: &str, threads: usize) -> Row {
    let about = match name {
        "cpu" => "built-in tracer",
        _ => "slow tracer to judge the others by",
    };
    let plural = if threads == 1 { "" } else { "s" };
    [
        name.to_owned(),
        "CPU".to_owned(),
        format!("{about}, {threads} thread{plural}"),
        "scenec".to_owned(),
        env!("CARGO_PKG_VERSION").to_owned(),
        "-".to_owned(),
        "-".to_owned(),
        "yes".to_owned(),
    ]
}

fn opencl(info: &DeviceInfo) -> Row {
    [
        request(info),
        info.kind.to_string(),
        info.name.clone(),
        info.platform.clone(),
        info.version.clone(),
        info.driver.clone(),
        memory(info.global_memory),
        if info.has_f64 { "yes" } else { "no" }.to_owned(),
    ]
}

fn memory(bytes: u64) -> String {
    match bytes {
        0 => "-".to_owned(),
        _ => format!("{:.1} GiB", bytes as f64 / f64::from(1 << 30)),
    }
}

#[cfg(test)]
mod tests {
    use scenec_device::Discovery;

    use super::listing;

    #[test]
    fn a_machine_without_devices_has_the_built_in_tracers_and_says_why() {
        let mut found = Discovery::default();
        found.notes.push("no library".to_owned());
        let text = listing(&found, 1);
        let lines: Vec<_> = text.lines().collect();
        assert!(
            lines[1].starts_with("cpu        CPU   built-in tracer, 1 thread "),
            "{text}"
        );
        assert!(lines[2].starts_with("reference  CPU   slow tracer"), "{text}");
        assert_eq!(lines[3..], ["", "note: no library", "--device auto takes cpu"]);
    }
}
