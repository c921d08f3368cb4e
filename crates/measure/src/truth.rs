//! The reference: the scene by the slow tracer, in f64, with nothing dropped, at many samples; and its own error.

use std::fmt::{self, Debug, Write as _};
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use scenec_picture::{Exact, Layers, Limits, Picture, Request, TraceError, Tracer, Watch, Window, write_whole};
use scenec_reference::Reference;
use scenec_scene::Scene;

/// The first bytes of a stored reference.
const MAGIC: &[u8; 8] = b"scenref1";

/// Rows that are traced at a time.
const BAND: u32 = 8;

/// The scene as exactly as it can be had.
#[derive(Clone, PartialEq, Debug)]
pub struct Truth {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Samples per pixel.
    pub samples: u32,
    /// The pixels, row by row.
    pub exact: Exact,
    /// The largest change of any component from the first half of the samples to all of them: an estimate of its own
    /// error that errs on the large side.
    pub own_max: f64,
    /// The root of the mean square of these changes.
    pub own_rms: f64,
    /// Whether it was found where references are kept.
    pub kept: bool,
}

/// Where references are kept, and what tells apart those of another program.
#[derive(Clone, Debug, Default)]
pub(crate) struct Shelf {
    /// The folder.
    pub(crate) folder: Option<PathBuf>,
    /// Anything that changes when the program does.
    pub(crate) salt: Vec<u8>,
}

impl Truth {
    /// Takes it from the shelf, or traces it and puts it there. `counter` hears of each sample that is done.
    ///
    /// # Errors
    /// Those of the tracer. A shelf that can't be read or written is done without.
    pub(crate) fn of(
        scene: &Scene,
        samples: u32,
        shelf: &Shelf,
        watch: &Watch,
        counter: &Watch,
    ) -> Result<Self, TraceError> {
        let place = shelf.folder.as_ref().map(|folder| {
            let key = key(scene, samples, &shelf.salt);
            folder.join(format!("{key:032x}.reference"))
        });
        let (width, height) = (scene.settings.width, scene.settings.height);
        let pixels = u64::from(width) * u64::from(height);
        if let Some(found) = place.as_deref().and_then(|path| read(path, width, height, samples)) {
            counter.advance(work(pixels, samples));
            return Ok(found);
        }
        let all = trace(scene, samples, watch, counter)?;
        let half = trace(scene, samples.div_ceil(2), watch, counter)?;
        let mut changes = (0.0_f64, 0.0);
        for change in all
            .as_flattened()
            .iter()
            .zip(half.as_flattened())
            .map(|(a, b)| (a - b).abs())
        {
            changes = (changes.0.max(change), changes.1 + change * change);
        }
        let truth = Self {
            width,
            height,
            samples,
            own_max: changes.0,
            own_rms: (changes.1 / all.as_flattened().len().max(1) as f64).sqrt(),
            exact: all,
            kept: false,
        };
        if let Some(path) = place {
            // The next run traces it again; this one loses nothing.
            truth.keep(&path).unwrap_or_default();
        }
        Ok(truth)
    }

    /// The nearest picture.
    ///
    /// # Errors
    /// If there is no memory for it.
    pub fn picture(&self) -> Result<Picture, TraceError> {
        let mut picture = Picture::black(self.width, self.height)?;
        for (pixel, exact) in picture.pixels_mut().iter_mut().zip(&self.exact) {
            *pixel = exact.map(|value| (value as f32).clamp(f32::MIN, f32::MAX));
        }
        Ok(picture)
    }

    fn keep(&self, path: &Path) -> io::Result<()> {
        fs::create_dir_all(path.parent().unwrap_or(Path::new(".")))?;
        write_whole(path, |out| {
            out.write_all(MAGIC)?;
            for number in [self.width, self.height, self.samples] {
                out.write_all(&number.to_le_bytes())?;
            }
            for value in [self.own_max, self.own_rms].iter().chain(self.exact.as_flattened()) {
                out.write_all(&value.to_le_bytes())?;
            }
            Ok::<(), io::Error>(())
        })
    }
}

/// How many samples the tracer takes for a reference, its first half traced once more.
pub(crate) fn work(pixels: u64, samples: u32) -> u64 {
    pixels * (u64::from(samples) + u64::from(samples.div_ceil(2)))
}

/// A stored reference; `None` if there is none, or if it is not whole.
fn read(path: &Path, width: u32, height: u32, samples: u32) -> Option<Truth> {
    let bytes = fs::read(path).ok()?;
    let head = [width, height, samples].map(u32::to_le_bytes);
    let rest = bytes.strip_prefix(MAGIC)?.strip_prefix(head.as_flattened())?;
    let (numbers, []) = rest.as_chunks::<8>() else {
        return None;
    };
    let numbers: Vec<f64> = numbers.iter().map(|number| f64::from_le_bytes(*number)).collect();
    let (&[own_max, own_rms], components) = numbers.split_first_chunk::<2>()?;
    let (exact, []) = components.as_chunks::<3>() else {
        return None;
    };
    (exact.len() as u64 == u64::from(width) * u64::from(height)).then(|| Truth {
        width,
        height,
        samples,
        exact: exact.to_vec(),
        own_max,
        own_rms,
        kept: true,
    })
}

fn trace(scene: &Scene, samples: u32, watch: &Watch, counter: &Watch) -> Result<Exact, TraceError> {
    let mut scene = scene.clone();
    scene.settings.samples = samples;
    let mut tracer = Reference::new(&scene);
    let (width, height) = (scene.settings.width, scene.settings.height);
    let mut exact = Vec::new();
    for y in (0..height).step_by(BAND as usize) {
        let request = Request {
            window: Window {
                x: 0,
                y,
                width,
                height: BAND.min(height - y),
            },
            limits: Limits::NO_CUTOFF,
            layers: Layers {
                exact: true,
                ..Layers::default()
            },
            watch,
        };
        let frame = tracer.trace(&request)?;
        exact.extend(frame.exact.into_iter().flatten());
        counter.advance(request.window.pixels() * u64::from(samples));
    }
    Ok(exact)
}

/// A number for all that a reference depends on (FNV-1a, 128 bits; Fowler, Noll, Vo).
fn key(scene: &Scene, samples: u32, salt: &[u8]) -> u128 {
    let mut hash = Hash(0x6C62_272E_07BB_0142_62B8_2175_6295_C58D);
    hash.add(salt);
    // A scene's debugged form holds all of it, every number to its last bit. It can't fail, for a hash takes anything.
    write!(hash, "{samples} {:?}", scene as &dyn Debug).unwrap_or_default();
    hash.0
}

struct Hash(u128);

impl Hash {
    fn add(&mut self, bytes: &[u8]) {
        for byte in bytes {
            self.0 = (self.0 ^ u128::from(*byte)).wrapping_mul(0x0000_0000_0100_0000_0000_0000_0000_013B);
        }
    }
}

impl fmt::Write for Hash {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        self.add(text.as_bytes());
        Ok(())
    }
}
