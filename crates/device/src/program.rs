//! Kernels from their source, and what a device's compiler says against them.

use crate::error::{CACHE_HELP, DeviceError, line};
use ocl::core::{self, Context, DeviceId, ProgramBuildInfo, ProgramBuildInfoResult, ProgramBuildStatus};
use std::ffi::CString;

/// Kernels that have been built for the device of one session.
#[derive(Debug)]
pub struct Program {
    pub(crate) object: core::Program,
}

/// Compiles `source` for a device, whose name is for the messages.
pub(crate) fn build(
    context: &Context,
    device: DeviceId,
    name: &str,
    source: &str,
    options: &str,
) -> Result<Program, DeviceError> {
    let source = c_string(source, "the kernels")?;
    let options = c_string(options, "the build options")?;
    let object = core::create_program_with_source(context, &[source])
        .map_err(|error| DeviceError::of_call("create a program", &error))?;
    let built = core::build_program(&object, Some(&[device]), &options, None, None);
    // The bindings take a failure that left no log for a success.
    let status = core::get_program_build_info(&object, device, ProgramBuildInfo::BuildStatus);
    match (built, status) {
        (Ok(()), Ok(ProgramBuildInfoResult::BuildStatus(ProgramBuildStatus::Success))) => Ok(Program { object }),
        (built, _) => Err(build_error(&log(&object, device), name, &options, built.err().as_ref())),
    }
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
