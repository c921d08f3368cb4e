//! Kernels from their source, or from what a device's compiler made of it before, and what it says against them.

use crate::cache::{Cache, Hash};
use crate::error::{CACHE_HELP, DeviceError, line};
use crate::info::DeviceInfo;
use ocl::core::{self, Context, DeviceId};
use ocl::core::{ProgramBuildInfo, ProgramBuildInfoResult, ProgramBuildStatus, ProgramInfo, ProgramInfoResult};
use std::ffi::CString;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// Kernels that have been built for the device of one session.
#[derive(Debug)]
pub struct Program {
    pub(crate) object: core::Program,
    key: Hash,
    /// Whether the cache has it.
    kept: AtomicBool,
    /// What the compiler took; nothing if it was not asked.
    compiled: Option<Duration>,
}

impl Program {
    /// What the device's compiler took, or nothing if the program was kept from an earlier run.
    #[must_use]
    pub fn compiled(&self) -> Option<Duration> {
        self.compiled
    }

    /// Puts the program into the cache, if it is not from there: after its first run, since some drivers compile a part
    /// of it only then. It is not even asked for where nothing is kept: for a whole one PoCL compiles what may never run.
    pub(crate) fn keep(&self, cache: &Cache) {
        if !cache.is_on() || self.kept.swap(true, Ordering::Relaxed) {
            return;
        }
        if let Ok(ProgramInfoResult::Binaries(binaries)) = core::get_program_info(&self.object, ProgramInfo::Binaries)
            && let [binary] = binaries.as_slice()
            && !binary.is_empty()
        {
            cache.put(self.key, binary);
        }
    }
}

/// What tells a compiled program from all others.
pub(crate) fn key(info: &DeviceInfo, source: &str, options: &str) -> Hash {
    let [a, b, c, d] = info.identity();
    Hash::of(&[source.as_bytes(), options.as_bytes(), a, b, c, d])
}

/// Takes the program of `source` from the cache, or compiles it for a device.
pub(crate) fn build(
    context: &Context,
    device: DeviceId,
    info: &DeviceInfo,
    (source, options): (&str, &str),
    cache: &Cache,
) -> Result<Program, DeviceError> {
    let key = key(info, source, options);
    let source = c_string(source, "the kernels")?;
    let options = c_string(options, "the build options")?;
    if let Some(binary) = cache.get(key) {
        match load(context, device, &binary, &options) {
            Some(object) => {
                return Ok(Program {
                    object,
                    key,
                    kept: true.into(),
                    compiled: None,
                });
            }
            None => cache.forget(key),
        }
    }
    let begin = Instant::now();
    let object = compile(context, device, &info.name, source, &options)?;
    Ok(Program {
        object,
        key,
        kept: false.into(),
        compiled: Some(begin.elapsed()),
    })
}

/// A program that the compiler made before; a driver that won't have it any more gets the source.
fn load(context: &Context, device: DeviceId, binary: &[u8], options: &CString) -> Option<core::Program> {
    let object = core::create_program_with_binary(context, &[device], &[binary]).ok()?;
    core::build_program(&object, Some(&[device]), options, None, None).ok()?;
    succeeded(&object, device).then_some(object)
}

fn compile(
    context: &Context,
    device: DeviceId,
    name: &str,
    source: CString,
    options: &CString,
) -> Result<core::Program, DeviceError> {
    let object = core::create_program_with_source(context, &[source])
        .map_err(|error| DeviceError::of_call("create a program", &error))?;
    let built = core::build_program(&object, Some(&[device]), options, None, None);
    // The bindings take a failure that left no log for a success.
    if built.is_ok() && succeeded(&object, device) {
        return Ok(object);
    }
    Err(build_error(&log(&object, device), name, options, built.err().as_ref()))
}

fn succeeded(program: &core::Program, device: DeviceId) -> bool {
    matches!(
        core::get_program_build_info(program, device, ProgramBuildInfo::BuildStatus),
        Ok(ProgramBuildInfoResult::BuildStatus(ProgramBuildStatus::Success))
    )
}

fn log(program: &core::Program, device: DeviceId) -> String {
    match core::get_program_build_info(program, device, ProgramBuildInfo::BuildLog) {
        Ok(ProgramBuildInfoResult::BuildLog(log)) => log,
        _ => String::new(),
    }
}

fn build_error(log: &str, name: &str, options: &CString, error: Option<&core::Error>) -> DeviceError {
    if let Some(cause) = first_error(log) {
        return DeviceError::new(format!("the kernels don't compile for {name}: {cause}")).with_log(log);
    }
    let task = format!(
        "compile the kernels for {name} with the options \"{}\"",
        options.to_string_lossy()
    );
    match error {
        Some(error @ core::Error::Api(_)) => DeviceError::of_call(&task, error),
        _ => DeviceError::new(format!("couldn't {task}: the compiler gives no reason")).with_help(CACHE_HELP),
    }
}

fn c_string(text: &str, what: &str) -> Result<CString, DeviceError> {
    CString::new(text).map_err(|_| DeviceError::new(format!("{what} contain a zero byte")))
}

/// The line of a compiler's log that says most: the first that names an error, else the first with words.
fn first_error(log: &str) -> Option<String> {
    let lines = || log.lines().map(line).filter(|one| !one.is_empty());
    lines().find(|one| one.contains("error")).or_else(|| lines().next())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(log: &str, expect: Option<&str>) {
        assert_eq!(first_error(log).as_deref(), expect);
    }

    #[test]
    fn the_telling_line_of_a_log_is_found() {
        let log = "warning: x\n\n  k.cl:3:1: error: use of 'y'\n1 error generated\n";
        check(log, Some("k.cl:3:1: error: use of 'y'"));
        check("\n something \n", Some("something"));
        check(" \n\n", None);
    }

    #[test]
    fn a_failure_without_a_log_names_the_options() {
        let error = build_error("\n", "Box", &CString::new("-x").unwrap(), None);
        assert!(
            error
                .message()
                .contains("for Box with the options \"-x\": the compiler gives no reason"),
            "{error}"
        );
        assert_eq!(error.log(), None);
    }
}
