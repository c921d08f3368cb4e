//! Whole processes: this program, rendering a file.

use std::env;
use std::ffi::OsString;
use std::io;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use scenec_measure::{Machine, Program, Setting, Start};
use scenec_picture::{TraceError, Watch};
use tempfile::TempDir;

use crate::failure::Failure;

/// Where compilers of OpenCL programs keep what they made.
const COMPILED: [&str; 2] = ["POCL_CACHE_DIR", "CUDA_CACHE_PATH"];

/// How long a process may take with a setting that promises nothing, not even an end.
const PATIENCE: Duration = Duration::from_secs(10);

/// Renders one file again and again.
pub(super) struct Renders<'a> {
    program: PathBuf,
    file: &'a Path,
    size: String,
    /// Where the pictures go, and what compilers keep.
    folder: TempDir,
    watch: &'a Watch,
}

impl<'a> Renders<'a> {
    pub(super) fn of(file: &'a Path, size: (u32, u32), watch: &'a Watch) -> Result<Self, Failure> {
        let unusable = |error: std::io::Error| Failure::Unusable(format!("no place to render: {error}"));
        Ok(Self {
            program: env::current_exe().map_err(unusable)?,
            file,
            size: format!("{}x{}", size.0, size.1),
            folder: tempfile::tempdir().map_err(unusable)?,
            watch,
        })
    }

    /// The seconds from start to end of a process that renders with this setting.
    pub(super) fn run(&mut self, setting: &Setting, start: Start) -> Result<f64, TraceError> {
        let failed = |error: &dyn std::fmt::Display| TraceError::Failed(format!("a render failed: {error}"));
        let mut command = Command::new(&self.program);
        command
            .arg("render")
            .arg(self.file)
            .arg("-o")
            .arg(self.folder.path().join("out.png"));
        command.args(self.arguments(setting));
        // Another folder for each cold start: what is there is never removed under a running driver.
        let cold = tempfile::tempdir_in(self.folder.path()).map_err(|error| failed(&error))?;
        if start == Start::Cold {
            command.envs(COMPILED.map(|name| (name, cold.path())));
        }
        let quiet = command
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(Stdio::piped());
        let begin = Instant::now();
        let ran = if setting.machine.promises() {
            quiet.output()
        } else {
            quiet.spawn().and_then(ended)
        };
        let ran = ran.map_err(|error| failed(&error))?;
        let seconds = begin.elapsed().as_secs_f64();
        if self.watch.stopped() {
            // The terminal tells every process of it.
            return Err(TraceError::Cancelled);
        }
        if !ran.status.success() {
            return Err(failed(&String::from_utf8_lossy(&ran.stderr).trim_end()));
        }
        Ok(seconds)
    }

    fn arguments(&self, setting: &Setting) -> Vec<OsString> {
        let (device, program) = match &setting.machine {
            Machine::Cpu => ("cpu".to_owned(), Program::Made),
            Machine::OpenCl { device, program } => (format!("opencl:{}", device.index), *program),
        };
        let mut words = vec!["--quiet".to_owned()];
        for (option, value) in [
            ("--size", self.size.clone()),
            ("--device", device),
            ("--precision", setting.precision.to_string()),
            ("--samples", setting.samples.to_string()),
            ("--raydepth", setting.raydepth.to_string()),
            ("--cutoff", setting.cutoff.to_string()),
        ] {
            words.extend([option.to_owned(), value]);
        }
        words.extend(match program {
            Program::Made => None,
            Program::General => Some("--generic".to_owned()),
            Program::FastMath => Some("--fast-math".to_owned()),
        });
        words.into_iter().map(OsString::from).collect()
    }
}

/// Waits for a process that may never end by itself, and only so long.
fn ended(mut child: Child) -> io::Result<Output> {
    let begin = Instant::now();
    while child.try_wait()?.is_none() {
        if begin.elapsed() > PATIENCE {
            child.kill()?;
            child.wait()?;
            return Err(io::Error::other(format!("it did not end in {} s", PATIENCE.as_secs())));
        }
        sleep(Duration::from_millis(1));
    }
    child.wait_with_output()
}
