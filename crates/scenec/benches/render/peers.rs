//! Who draws: ourselves on each device, POV-Ray, and a small program over Embree. Each is a process from start to end.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::time::Instant;

/// What one run took.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Run {
    /// From the start of the process to its end, ms.
    pub(crate) whole: f64,
    /// What the tracer needs before its first ray once the scene is read, ms: a plan, a hierarchy, a program.
    pub(crate) prepare: Option<f64>,
    /// Tracing alone, ms.
    pub(crate) trace: Option<f64>,
    /// Rays of all kinds.
    pub(crate) rays: Option<f64>,
}

impl Run {
    /// Millions of rays in a second of tracing.
    pub(crate) fn rate(&self) -> Option<f64> {
        Some(self.rays? / self.trace? / 1e3)
    }
}

/// Whoever can be asked for a picture.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Peer {
    Cpu,
    CpuDouble,
    OpenCl,
    OpenClGeneric,
    OpenClCold,
    PovRay,
    Embree,
}

impl Peer {
    pub(crate) const ALL: [Self; 7] = [
        Self::Cpu,
        Self::CpuDouble,
        Self::OpenCl,
        Self::OpenClGeneric,
        Self::OpenClCold,
        Self::PovRay,
        Self::Embree,
    ];

    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Cpu => "cpu",
            Self::CpuDouble => "cpu-f64",
            Self::OpenCl => "opencl",
            Self::OpenClGeneric => "opencl-generic",
            Self::OpenClCold => "opencl-cold",
            Self::PovRay => "povray",
            Self::Embree => "embree",
        }
    }

    /// Whether it takes so long that one round must do for large scenes.
    pub(crate) const fn is_slow(self) -> bool {
        !matches!(self, Self::Cpu | Self::Embree)
    }
}

/// The files of one scene; what can't be told to a peer is not there.
pub(crate) struct Files {
    pub(crate) scene: PathBuf,
    pub(crate) pov: Option<PathBuf>,
    pub(crate) numbers: Option<PathBuf>,
    pub(crate) size: (u32, u32),
}

/// Where things are made, and the program over Embree if it could be made.
pub(crate) struct Bench<'a> {
    pub(crate) folder: &'a Path,
    pub(crate) embree: Option<PathBuf>,
}

/// Compiles the program over Embree, where there are a compiler and the library.
pub(crate) fn embree(folder: &Path) -> Option<PathBuf> {
    let program = folder.join("embree");
    let built = Command::new("g++")
        .args(["-O3", "-march=native", "-pthread", "-o"])
        .arg(&program)
        .arg(concat!(env!("CARGO_MANIFEST_DIR"), "/benches/render/embree.cpp"))
        .arg("-lembree3")
        .output();
    built.is_ok_and(|output| output.status.success()).then_some(program)
}

impl Bench<'_> {
    /// One run; nothing where the peer is not there, fails, or can't be told this scene.
    pub(crate) fn run(&self, peer: Peer, files: &Files) -> Option<Run> {
        match peer {
            Peer::Cpu => self.ours(files, &["--device", "cpu"], false),
            Peer::CpuDouble => self.ours(files, &["--device", "cpu", "--precision", "f64"], false),
            Peer::OpenCl => self.ours(files, &["--device", "opencl"], false),
            Peer::OpenClGeneric => self.ours(files, &["--device", "opencl", "--generic"], false),
            Peer::OpenClCold => self.ours(files, &["--device", "opencl"], true),
            Peer::PovRay => self.povray(files),
            Peer::Embree => self.library(files),
        }
    }

    /// The whole process, and then another one that says what its stages took: to say how wrong its picture may be takes time
    /// that no other peer spends.
    fn ours(&self, files: &Files, device: &[&str], cold: bool) -> Option<Run> {
        let (whole, _) = timed(&mut self.render(files, device, cold)?)?;
        let (_, output) = timed(self.render(files, device, cold)?.arg("--stats"))?;
        let account = String::from_utf8_lossy(&output.stderr).into_owned();
        Some(Run {
            whole,
            prepare: Some(stage(&account, "plan")? + stage(&account, "prepare")?),
            trace: stage(&account, "trace"),
            rays: account
                .lines()
                .find_map(|line| line.strip_prefix("rays")?.split("in all").next())
                .and_then(|count| count.trim().replace(',', "").parse().ok()),
        })
    }

    fn render(&self, files: &Files, device: &[&str], cold: bool) -> Option<Command> {
        let cache = self.folder.join("cache");
        if cold {
            std::fs::remove_dir_all(&cache).unwrap_or_default();
            std::fs::create_dir_all(&cache).ok()?;
        }
        let mut command = Command::new(env!("CARGO_BIN_EXE_scenec"));
        command
            .arg("render")
            .arg(&files.scene)
            .arg("-o")
            .arg(self.folder.join("ours.png"));
        command
            .args(["--quiet", "--size"])
            .arg(format!("{}x{}", files.size.0, files.size.1))
            .args(device);
        if cold {
            command.env("POCL_CACHE_DIR", &cache).env("XDG_CACHE_HOME", &cache);
        }
        Some(command)
    }

    /// What `scenec plan` says that the built-in tracer will take to trace, ms.
    pub(crate) fn foreseen(&self, files: &Files) -> Option<f64> {
        let mut command = Command::new(env!("CARGO_BIN_EXE_scenec"));
        command.arg("plan").arg(&files.scene);
        command.args(["--quiet", "--device", "cpu", "--output-format", "json", "--size"]);
        command.arg(format!("{}x{}", files.size.0, files.size.1));
        let (_, output) = timed(&mut command)?;
        let plan: serde_json::Value = serde_json::from_slice(&output.stdout).ok()?;
        plan["forecast"]["milliseconds"].as_f64()
    }

    fn povray(&self, files: &Files) -> Option<Run> {
        let mut command = Command::new("povray");
        command.arg(format!("+I{}", files.pov.as_ref()?.display()));
        command.arg(format!("+O{}", self.folder.join("povray.png").display()));
        command
            .args([format!("+W{}", files.size.0), format!("+H{}", files.size.1)])
            .args(["-A", "-D", "-P", "+FN8"]);
        command.env("HOME", self.folder).current_dir(self.folder);
        let (whole, _) = timed(&mut command)?;
        Some(Run {
            whole,
            prepare: None,
            trace: None,
            rays: None,
        })
    }

    fn library(&self, files: &Files) -> Option<Run> {
        let mut command = Command::new(self.embree.as_ref()?);
        command.arg(files.numbers.as_ref()?).arg(self.folder.join("embree.ppm"));
        let (whole, output) = timed(&mut command)?;
        let words = String::from_utf8_lossy(&output.stdout).into_owned();
        let mut numbers = words.split_whitespace().map_while(|word| word.parse().ok());
        Some(Run {
            whole,
            prepare: numbers.next(),
            trace: numbers.next(),
            rays: numbers.next(),
        })
    }
}

fn timed(command: &mut Command) -> Option<(f64, Output)> {
    let start = Instant::now();
    let output = command.output().ok()?;
    let whole = start.elapsed().as_secs_f64() * 1e3;
    output.status.success().then_some((whole, output))
}

/// The milliseconds of a stage in the account that `--stats` gives.
fn stage(account: &str, name: &str) -> Option<f64> {
    let times = account.lines().find_map(|line| line.strip_prefix("time"))?;
    times.split(',').find_map(|part| {
        part.trim()
            .strip_prefix(name)?
            .trim()
            .strip_suffix("ms")?
            .trim()
            .parse()
            .ok()
    })
}
