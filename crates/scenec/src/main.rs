//! The command line: `scenec check`, and one file in `commands/` for every other subcommand.

mod commands;
mod exit;
mod input;
mod interrupt;
mod progress;
mod report;

use std::process::ExitCode;

use clap::{Parser, Subcommand};

/// Check and render scene files.
#[derive(Parser)]
#[command(version, propagate_version = true, arg_required_else_help = true)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    Check(commands::check::Check),
    Render(Box<commands::render::Render>),
    Devices(commands::devices::Devices),
}

fn main() -> ExitCode {
    let exit = match Arguments::parse().command {
        Command::Check(check) => check.run(),
        Command::Render(render) => render.run(),
        Command::Devices(devices) => devices.run(),
    };
    exit.into()
}
