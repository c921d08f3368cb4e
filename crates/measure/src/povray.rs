//! POV-Ray as a second opinion: a scene in its language, each surface in a colour of its own, and what it sees.
//!
//! Only what shows first is asked for. Light means something else there, and surfaces are what breaks.

mod text;

use std::fs::{self, File};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use scenec_scene::Scene;

pub use text::text;

/// How long POV-Ray may take for one picture.
const PATIENCE: Duration = Duration::from_secs(10);

/// Whether there is a POV-Ray that can be asked.
#[must_use]
pub fn is_there() -> bool {
    let asked = Command::new("povray")
        .arg("--version")
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status();
    asked.is_ok()
}

/// The leaf that POV-Ray sees at each pixel of a scene, row by row, or [`scenec_picture::NOTHING`], without anti-aliasing.
///
/// # Errors
/// A few words: it isn't installed, takes too long, stops with an error, or the scene is not for it.
pub fn leaves(scene: &Scene) -> Result<Vec<u32>, String> {
    let text = text(scene)?;
    let failed = |error: std::io::Error| format!("POV-Ray can't be run: {error}");
    let folder = tempfile::tempdir().map_err(failed)?;
    let at = |name: &str| folder.path().join(name);
    fs::write(at("in.pov"), text).map_err(failed)?;
    let child = command(scene, folder.path())
        .stdout(Stdio::null())
        .stderr(File::create(at("log")).map_err(failed)?)
        .spawn()
        .map_err(failed)?;
    if !ends_well(child).map_err(failed)? {
        let log = fs::read(at("log")).unwrap_or_default();
        return Err(reason(&String::from_utf8_lossy(&log)));
    }
    let bytes = fs::read(at("out.ppm")).map_err(failed)?;
    pixels(&bytes, scene).ok_or_else(|| "POV-Ray wrote a picture of another size".to_owned())
}

/// How it is called: one thread, no anti-aliasing, no window, no gamma, in a home of its own.
fn command(scene: &Scene, folder: &Path) -> Command {
    let mut command = Command::new("povray");
    command
        .args([
            "+Iin.pov",
            "+Oout.ppm",
            "+FP8",
            "-A",
            "-D",
            "-P",
            "+WT1",
            "File_Gamma=1.0",
        ])
        .arg(format!("+W{}", scene.settings.width))
        .arg(format!("+H{}", scene.settings.height))
        .env("HOME", folder)
        .current_dir(folder);
    command
}

/// Waits, but not for ever; false if it failed or had to be stopped.
fn ends_well(mut child: Child) -> std::io::Result<bool> {
    let begin = Instant::now();
    while begin.elapsed() < PATIENCE {
        if let Some(status) = child.try_wait()? {
            return Ok(status.success());
        }
        sleep(Duration::from_millis(5));
    }
    child.kill()?;
    child.wait()?;
    Ok(false)
}

/// What its log says of a run that failed.
fn reason(log: &str) -> String {
    let error = log.lines().find(|line| line.contains("rror:"));
    error.map_or_else(
        || format!("no picture in {} s", PATIENCE.as_secs()),
        |line| line.trim().to_owned(),
    )
}

/// The pixels stand at the end of the file, three bytes each.
fn pixels(bytes: &[u8], scene: &Scene) -> Option<Vec<u32>> {
    let count = scene.settings.width as usize * scene.settings.height as usize * 3;
    let tail = bytes.get(bytes.len().checked_sub(count)?..)?;
    let (colours, _) = tail.as_chunks::<3>();
    Some(colours.iter().map(|colour| text::leaf(*colour)).collect())
}

/// The share of a picture's pixels that show another surface than the reference does, of those that are off the edges: whose
/// eight neighbours show in the reference what they show. Zero where there are none.
#[must_use]
pub fn astray(seen: &[u32], reference: &[u32], width: usize) -> f64 {
    let height = reference.len() / width.max(1);
    let plain = |i: &usize| {
        let (x, y) = (i % width, i / width);
        let columns = x.saturating_sub(1)..(x + 2).min(width);
        let mut rows = y.saturating_sub(1)..(y + 2).min(height);
        rows.all(|row| {
            columns
                .clone()
                .all(|column| reference[row * width + column] == reference[*i])
        })
    };
    let counting: Vec<_> = (0..reference.len()).filter(plain).collect();
    let wrong = counting.iter().filter(|i| seen.get(**i) != Some(&reference[**i]));
    wrong.count() as f64 / counting.len().max(1) as f64
}

#[cfg(test)]
mod tests {
    use scenec_picture::NOTHING;

    use super::astray;

    #[test]
    fn only_what_is_off_the_edges_counts() {
        let reference: Vec<u32> = [[1, 1, 1, NOTHING]; 3].concat();
        let seen: Vec<u32> = [[1, 2, 1, 1]; 3].concat();
        // Of the twelve the six of the first two columns are off the edge, and three of these show something else.
        assert!((astray(&seen, &reference, 4) - 0.5).abs() < 1e-15);
        assert!(astray(&reference, &reference, 4) < 1e-15);
    }
}
