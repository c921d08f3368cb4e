//! How fast the stages behind `check` and `fmt` are, in bytes of a generated scene: `cargo bench -p scenec-lint`.

#![allow(clippy::unwrap_used, reason = "a benchmark may stop at once")]

use std::fmt::Write;

use divan::Bencher;
use divan::counter::BytesCount;
use scenec_interpret::interpret;
use scenec_syntax::{FormatStyle, Lines, format, parse, scan};
use scenec_text::SourceFile;

/// Sizes of the scenes in bytes; a larger one is slightly longer than it says.
const SIZES: [usize; 3] = [1_000, 1_000_000, 100_000_000];

/// As in the program.
#[global_allocator]
static MEMORY: scenec_memory::Memory = scenec_memory::Memory;

fn main() {
    scenec_memory::keep_freed();
    divan::main();
}

/// A scene of transformed spheres in a chain of unions, with comments, without a finding of the early stages.
fn scene(size: usize) -> SourceFile {
    let settings = "width := 600\nheight := 400\nraydepth := 4\neyepos_x := 4\neyepos_y := 1\neyepos_z := 0.5\n\
        lookat_x := 0\nlookat_y := 0\nlookat_z := 0\nambient_r := 0.2\nambient_g := 0.2\nambient_b := 1\n\
        ambient_int_r := 1\nambient_int_g := 1\nambient_int_b := 1\n*lamp := 4 4 4 1 1 1\n\
        ?red := 0.1 0.5 0.3 0.3 0 1.125 4 1 0.1 0.1\n!u0 := hp\n";
    let mut text = settings.to_owned();
    let mut count = 0;
    while text.len() < size {
        let (x, z) = (count % 1000, count / 1000);
        writeln!(
            text,
            "/ ball {count}\n!s{count} := sphere\n!s{count} ?= red\n!s{count} *= 1.{x} 0.5 0.25\n\
             !s{count} += {x}.25 1 -{z}.5\n!u{} := u{count} | s{count}",
            count + 1
        )
        .unwrap();
        count += 1;
    }
    writeln!(text, "!u{count} <=").unwrap();
    SourceFile::new("generated", text).unwrap()
}

fn measure<T>(bencher: Bencher, source: &SourceFile, stage: impl Fn(&SourceFile) -> T + Sync) {
    bencher
        .counter(BytesCount::of_str(source.text()))
        .bench(|| stage(divan::black_box(source)));
}

/// A stage that begins with the bytes of a file.
fn measure_bytes<T>(bencher: Bencher, source: &SourceFile, stage: impl Fn(Vec<u8>) -> T + Sync) {
    bencher
        .counter(BytesCount::of_str(source.text()))
        .with_inputs(|| source.text().as_bytes().to_vec())
        .bench_values(stage);
}

#[divan::bench(args = SIZES, sample_size = 1, sample_count = 10)]
fn line_index(bencher: Bencher, size: usize) {
    measure_bytes(bencher, &scene(size), |bytes| {
        SourceFile::from_bytes("generated", bytes).unwrap()
    });
}

#[divan::bench(args = SIZES, sample_size = 1, sample_count = 10)]
fn lexer(bencher: Bencher, size: usize) {
    measure(bencher, &scene(size), |source| scan(source.text()).count());
}

#[divan::bench(args = SIZES, sample_size = 1, sample_count = 10)]
fn lines_one_by_one(bencher: Bencher, size: usize) {
    measure(bencher, &scene(size), |source| Lines::new(source).count());
}

#[divan::bench(args = SIZES, sample_size = 1, sample_count = 10)]
fn lex_and_parse(bencher: Bencher, size: usize) {
    measure(bencher, &scene(size), parse);
}

#[divan::bench(args = SIZES, sample_size = 1, sample_count = 10)]
fn interpretation(bencher: Bencher, size: usize) {
    let source = scene(size);
    let (lines, _) = parse(&source);
    measure(bencher, &source, |source| interpret(source, &lines));
}

#[divan::bench(args = SIZES, sample_size = 1, sample_count = 10)]
fn rules(bencher: Bencher, size: usize) {
    let source = scene(size);
    let (lines, _) = parse(&source);
    let (interpretation, _) = interpret(&source, &lines);
    assert!(interpretation.scene.is_some(), "a file with errors skips most rules");
    measure(bencher, &source, |source| scenec_lint::lint(source, &interpretation));
}

/// From the bytes of a file to its findings, on one thread.
#[divan::bench(args = SIZES, sample_size = 1, sample_count = 10)]
fn check_without_geometry(bencher: Bencher, size: usize) {
    measure_bytes(bencher, &scene(size), |bytes| {
        let (source, _) = SourceFile::from_bytes("generated", bytes).unwrap();
        let checked = scenec_lint::check_without_geometry(&source);
        (source, checked)
    });
}

#[divan::bench(args = SIZES, sample_size = 1, sample_count = 10)]
fn whole_check(bencher: Bencher, size: usize) {
    measure(bencher, &scene(size), scenec_lint::check);
}

#[divan::bench(args = SIZES, sample_size = 1, sample_count = 10)]
fn formatter(bencher: Bencher, size: usize) {
    let source = scene(size);
    let (lines, _) = parse(&source);
    measure(bencher, &source, |source| {
        format(source, &lines, FormatStyle::default())
    });
}

#[divan::bench(args = SIZES, sample_size = 1, sample_count = 10)]
fn aligning_formatter(bencher: Bencher, size: usize) {
    let source = scene(size);
    let (lines, _) = parse(&source);
    measure(bencher, &source, |source| {
        format(source, &lines, FormatStyle { align: true })
    });
}
