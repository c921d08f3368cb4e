//! The command line: `scenec check`, and one file in `commands/` for every other subcommand.

mod commands;
mod config;
mod diff;
mod exit;
mod failure;
mod files;
mod finding;
mod fix;
mod forecast;
mod input;
mod interrupt;
mod jobs;
mod levels;
mod output;
mod parallel;
mod progress;
mod report;
mod rewrite;
mod scenes;
mod values;
mod watch;

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
    Fmt(commands::fmt::Fmt),
    Render(Box<commands::render::Render>),
    Plan(Box<commands::plan::PlanOptions>),
    Bench(commands::bench::BenchOptions),
    Compare(commands::compare::Compare),
    Devices(commands::devices::Devices),
    Explain(commands::explain::Explain),
    Lsp(commands::lsp::Lsp),
    #[command(name = commands::preview_worker::NAME, hide = true)]
    PreviewWorker(commands::preview_worker::PreviewWorker),
}

#[global_allocator]
static MEMORY: scenec_memory::Memory = scenec_memory::Memory;

fn main() -> ExitCode {
    scenec_memory::keep_freed();
    let exit = match Arguments::parse().command {
        Command::Check(check) => check.run(),
        Command::Fmt(fmt) => fmt.run(),
        Command::Render(render) => render.run(),
        Command::Plan(plan) => plan.run(),
        Command::Bench(bench) => bench.run(),
        Command::Compare(compare) => compare.run(),
        Command::Devices(devices) => devices.run(),
        Command::Explain(explain) => explain.run(),
        Command::Lsp(lsp) => lsp.run(),
        Command::PreviewWorker(worker) => worker.run(),
    };
    exit.into()
}
