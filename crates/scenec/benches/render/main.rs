//! How fast pictures come about, beside POV-Ray and a program over Embree where they are installed:
//! `cargo bench -p scenec --bench render -- [--rounds N] [--scenes a,b] [--peers a,b] [--csv FILE]`.
//!
//! Peers take turns within a round, since a machine's speed drifts; what is shown are medians over the rounds, and ratios
//! of medians. Every single run goes to the CSV file.

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a benchmark may stop at once, and talks"
)]

mod peers;
mod scenes;
mod words;

use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

use peers::{Bench, Files, Peer, Run};

const SEED: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/seed.scene");

/// The seed scene in two sizes, before the generated ones.
const SEEDS: [(&str, (u32, u32)); 2] = [("seed", (600, 400)), ("seed-4k", (3840, 2160))];

fn main() {
    let options = Options::read();
    let folder = tempfile::tempdir().unwrap();
    let bench = Bench {
        folder: folder.path(),
        embree: peers::embree(folder.path()),
    };
    if bench.embree.is_none() && options.peers.contains(&Peer::Embree) {
        println!("no Embree 3 with a C++ compiler here: its column stays empty\n");
    }
    println!("| scene | who | whole ms | prepare ms | trace ms | Mray/s | whole, in cpu's | rate, in cpu's |");
    println!("|---|---|---:|---:|---:|---:|---:|---:|");
    let mut forecasts = String::new();
    let mut csv = String::from("scene,who,round,whole_ms,prepare_ms,trace_ms,rays\n");
    for name in &options.scenes {
        let (files, quick) = files(name, folder.path());
        let mut runs: Vec<Vec<Run>> = options.peers.iter().map(|_| Vec::new()).collect();
        for round in 0..options.rounds {
            for (peer, runs) in options.peers.iter().zip(&mut runs) {
                let skip = round > 0 && (runs.is_empty() || !quick && peer.is_slow());
                if let Some(run) = (!skip).then(|| bench.run(*peer, &files)).flatten() {
                    let Run {
                        whole,
                        prepare,
                        trace,
                        rays,
                    } = run;
                    let [prepare, trace, rays] = [prepare, trace, rays].map(cell);
                    writeln!(
                        csv,
                        "{name},{},{round},{whole:.3},{prepare},{trace},{rays}",
                        peer.name()
                    )
                    .unwrap();
                    runs.push(run);
                }
            }
        }
        rows(name, &options.peers, &runs);
        forecasts += &forecast(name, &bench, &files, &options.peers, &runs).unwrap_or_default();
        fs::write(&options.csv, &csv).unwrap();
    }
    if !forecasts.is_empty() {
        println!("\n| scene | foreseen ms | traced ms | foreseen, in traced's |\n|---|---:|---:|---:|\n{forecasts}");
    }
    println!("\nevery run: {}", options.csv.display());
}

/// What was foreseen for the built-in tracer beside what it took.
fn forecast(name: &str, bench: &Bench<'_>, files: &Files, peers: &[Peer], runs: &[Vec<Run>]) -> Option<String> {
    let at = peers.iter().position(|peer| *peer == Peer::Cpu)?;
    let (traced, foreseen) = (median(&runs[at])?.trace?, bench.foreseen(files)?);
    Some(format!(
        "| {name} | {} | {} | {:.2} |\n",
        cell(Some(foreseen)),
        cell(Some(traced)),
        foreseen / traced
    ))
}

/// One line for each peer that drew the scene, with ratios to the built-in tracer.
fn rows(name: &str, peers: &[Peer], runs: &[Vec<Run>]) {
    let medians: Vec<_> = runs.iter().map(|runs| median(runs)).collect();
    let cpu = peers
        .iter()
        .position(|peer| *peer == Peer::Cpu)
        .and_then(|at| medians[at]);
    for (peer, run) in peers.iter().zip(&medians) {
        let Some(run) = run else {
            continue;
        };
        let cells = [
            Some(run.whole),
            run.prepare,
            run.trace,
            run.rate(),
            cpu.map(|cpu| run.whole / cpu.whole),
            run.rate()
                .zip(cpu.and_then(|cpu| cpu.rate()))
                .map(|(rate, cpu)| rate / cpu),
        ];
        println!("| {name} | {} | {} |", peer.name(), cells.map(cell).join(" | "));
    }
}

fn cell(value: Option<f64>) -> String {
    value.map_or_else(String::new, |value| match value {
        x if x >= 100.0 => format!("{x:.0}"),
        x => format!("{x:.2}"),
    })
}

fn median(runs: &[Run]) -> Option<Run> {
    let middle = |value: fn(&Run) -> Option<f64>| {
        let mut values: Vec<_> = runs.iter().filter_map(value).collect();
        values.sort_unstable_by(f64::total_cmp);
        values.get(values.len() / 2).copied()
    };
    Some(Run {
        whole: middle(|run| Some(run.whole))?,
        prepare: middle(|run| run.prepare),
        trace: middle(|run| run.trace),
        rays: middle(|run| run.rays),
    })
}

/// Writes a scene for every peer; and whether it is quick.
fn files(name: &str, folder: &Path) -> (Files, bool) {
    let write = |extension: &str, text: String| {
        let path = folder.join(format!("{name}.{extension}"));
        fs::write(&path, text).unwrap();
        path
    };
    if let Some((_, size)) = SEEDS.iter().find(|(seed, _)| *seed == name) {
        let pov = include_str!("seed.pov").to_owned();
        return (
            Files {
                scene: SEED.into(),
                pov: Some(write("pov", pov)),
                numbers: None,
                size: *size,
            },
            true,
        );
    }
    let known = scenes::NAMES.iter().find(|known| **known == name);
    let model = scenes::model(known.unwrap_or_else(|| panic!("{name} is no scene of the benchmark")));
    let files = Files {
        scene: write("scene", words::scene(&model)),
        pov: Some(write("pov", words::pov(&model))),
        numbers: model.balls.then(|| write("numbers", words::numbers(&model))),
        size: model.size,
    };
    (files, model.quick)
}

struct Options {
    rounds: usize,
    scenes: Vec<String>,
    peers: Vec<Peer>,
    csv: PathBuf,
}

impl Options {
    fn read() -> Self {
        let mut options = Self {
            rounds: 5,
            scenes: SEEDS
                .iter()
                .map(|(name, _)| *name)
                .chain(scenes::NAMES)
                .map(str::to_owned)
                .collect(),
            peers: Peer::ALL.into(),
            csv: Path::new(env!("CARGO_TARGET_TMPDIR")).join("render.csv"),
        };
        let arguments: Vec<String> = std::env::args().skip(1).filter(|word| word != "--bench").collect();
        for pair in arguments.chunks(2) {
            let [name, value] = pair else {
                panic!("{} wants a value", pair[0]);
            };
            let peer = |word: &str| Peer::ALL.into_iter().find(|peer| peer.name() == word);
            match name.as_str() {
                "--rounds" => options.rounds = value.parse().unwrap(),
                "--scenes" => options.scenes = value.split(',').map(str::to_owned).collect(),
                "--peers" => options.peers = value.split(',').map(|word| peer(word).unwrap()).collect(),
                "--csv" => options.csv = value.into(),
                other => panic!("{other} is unknown"),
            }
        }
        options
    }
}
