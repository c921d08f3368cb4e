//! Where the picture goes and how it is written; all that can be known to fail is found out before anything is traced.

use std::fs;
use std::io::{self, Cursor, IsTerminal, Write};
use std::path::{Path, PathBuf};

use clap::Args;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use scenec_picture::{
    Bands, Depth, EncodeError, Encoding, Format, MAX_PIXELS, Picture, TooManyPixels, Transfer, Watch, Window, encode,
    write_whole,
};

use crate::failure::Failure;
use crate::interrupt::{Stoppable, while_writing};
use crate::values::named;

/// Arguments about the file that is written.
#[derive(Args, Debug)]
#[command(next_help_heading = "Output")]
pub(super) struct TargetOptions {
    /// The file to write; its extension says the format. `-` writes to standard output, in the format of --format
    #[arg(short, long, value_name = "OUT")]
    output: PathBuf,
    /// The format, whatever the extension says
    #[arg(long, value_name = "FORMAT", value_parser = format(), ignore_case = true)]
    format: Option<Format>,
    /// How a colour component is stored, where the format leaves a choice
    #[arg(long, value_name = "BITS", value_parser = named(Depth::ALL))]
    depth: Option<Depth>,
    /// How components become levels; floating-point formats hold them unchanged
    #[arg(long, value_name = "CURVE", default_value = "linear", value_parser = named(Transfer::ALL))]
    transfer: Transfer,
    /// From 1 (small) to 100 (faithful), for jpeg
    #[arg(long, value_name = "N", default_value_t = 90, value_parser = clap::value_parser!(u8).range(1..=100))]
    quality: u8,
}

/// A format by its name or one of its extensions.
fn format() -> impl TypedValueParser<Value = Format> {
    let value = |format: Format| PossibleValue::new(format.name()).aliases(format.extensions());
    PossibleValuesParser::new(Format::all().map(value)).try_map(|word| {
        let found = Format::from_name(&word).or_else(|| Format::from_path(&Path::new("x").with_extension(&word)));
        found.ok_or_else(|| format!("`{word}` is unknown"))
    })
}

/// A place that a picture can be written to.
#[derive(Debug)]
pub(super) struct Target {
    place: Place,
    encoding: Encoding,
}

/// Takes the next band of a picture.
pub(super) type Deliver<'a> = &'a mut dyn FnMut(&Picture) -> Result<(), Failure>;

#[derive(Debug)]
enum Place {
    /// A file, there already or not.
    File(PathBuf),
    /// What has a name and is no file, such as a pipe.
    Stream(PathBuf),
    Standard,
}

impl TargetOptions {
    /// The place and the way to write, so far as they can be known before there is a scene.
    pub(super) fn target(&self, input: &Path) -> Result<Target, Failure> {
        let place = Place::of(&self.output);
        let encoding = Encoding {
            format: self.chosen_format(&place)?,
            depth: self.depth,
            transfer: self.transfer,
            quality: self.quality,
        };
        encoding.check(1, 1).map_err(Failure::unusable)?;
        place.check(input)?;
        Ok(Target { place, encoding })
    }

    fn chosen_format(&self, place: &Place) -> Result<Format, Failure> {
        self.format.map_or_else(|| place.format(), Ok)
    }
}

impl Place {
    fn of(path: &Path) -> Self {
        if path.as_os_str() == "-" {
            Self::Standard
        } else if fs::metadata(path).is_ok_and(|there| !there.is_file() && !there.is_dir()) {
            Self::Stream(path.to_owned())
        } else {
            Self::File(path.to_owned())
        }
    }

    /// Refuses what can't be written to, and the scene.
    fn check(&self, input: &Path) -> Result<(), Failure> {
        match self {
            Self::Standard if io::stdout().is_terminal() => Err(Failure::unusable(
                "a picture is nothing for a terminal; send standard output elsewhere, or name a file with -o",
            )),
            Self::Standard | Self::Stream(_) => Ok(()),
            Self::File(path) => {
                writable(path).map_err(|error| cannot_write(path, &error))?;
                if same(path, input) {
                    return Err(cannot_write(path, &"it is the scene itself"));
                }
                Ok(())
            }
        }
    }

    /// The format that its extension says.
    fn format(&self) -> Result<Format, Failure> {
        match self {
            Self::Standard => Err(Failure::Unusable(format!(
                "standard output has no extension; --format says what to write: {}",
                list(|format| format.name().to_owned())
            ))),
            Self::File(path) | Self::Stream(path) => Format::from_path(path).ok_or_else(|| {
                Failure::Unusable(format!(
                    "the extension of {} is not one of a known format; use {}, or --format",
                    path.display(),
                    list(|format| format.extensions().join(", "))
                ))
            }),
        }
    }
}

/// Whether both are one file, there already or not.
fn same(a: &Path, b: &Path) -> bool {
    let whole = |path: &Path| match (fs::canonicalize(path), path.file_name()) {
        (Ok(whole), _) => Some(whole),
        (Err(_), Some(name)) => Some(fs::canonicalize(folder(path)).ok()?.join(name)),
        (Err(_), None) => None,
    };
    whole(a).is_some_and(|a| Some(a) == whole(b))
}

/// The folder that a file stands in.
fn folder(path: &Path) -> &Path {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
    folder.unwrap_or(Path::new("."))
}

fn list(words: fn(Format) -> String) -> String {
    Format::all().map(words).collect::<Vec<_>>().join(", ")
}

fn cannot_write(path: &Path, reason: &dyn std::fmt::Display) -> Failure {
    Failure::Unusable(format!("cannot write {}: {reason}", path.display()))
}

/// Whether a file can be made where this one is to stand.
fn writable(path: &Path) -> io::Result<()> {
    let path = match fs::metadata(path) {
        Ok(there) if there.is_dir() => return Err(io::ErrorKind::IsADirectory.into()),
        Ok(_) => fs::canonicalize(path)?,
        Err(_) => path.to_owned(),
    };
    // Asking for permissions would not tell of full disks and read-only ones; making a file does.
    tempfile::tempfile_in(folder(&path)).map(drop)
}

impl Target {
    /// A second file to write, in the usual way of the format that its extension says.
    pub(super) fn beside(path: &Path, input: &Path, first: &Self) -> Result<Self, Failure> {
        let place = Place::of(path);
        if matches!(place, Place::Standard) {
            return Err(Failure::unusable("an error map needs the name of a file"));
        }
        let encoding = Encoding::of(place.format()?);
        place.check(input)?;
        match &first.place {
            Place::File(other) if same(path, other) => Err(cannot_write(path, &"it is the picture itself")),
            _ => Ok(Self { place, encoding }),
        }
    }

    /// How its components are stored.
    pub(super) fn depth(&self) -> Depth {
        self.encoding.depth()
    }

    /// What people know the place as.
    pub(super) fn name(&self) -> String {
        match &self.place {
            Place::File(path) | Place::Stream(path) => path.display().to_string(),
            Place::Standard => "<stdout>".to_owned(),
        }
    }

    /// Refuses a picture that the format can't hold.
    pub(super) fn check(&self, window: &Window) -> Result<(), Failure> {
        let fits = self.encoding.check(window.width, window.height);
        fits.map_err(|error| Failure::Unusable(format!("cannot write {}: {error}", self.name())))
    }

    /// Whether a picture of this size is written band by band, since it can't be held at once.
    ///
    /// # Errors
    /// It can't be held, and can't be written so either.
    pub(super) fn wants_bands(&self, window: &Window) -> Result<bool, Failure> {
        if window.pixels() <= MAX_PIXELS {
            return Ok(false);
        }
        let named = !matches!(self.place, Place::Standard);
        if named && self.encoding.format.takes_bands() {
            return Ok(true);
        }
        let able: Vec<_> = Format::all().filter(|format| format.takes_bands()).collect();
        let able: Vec<_> = able.iter().map(|format| format.name()).collect();
        Err(Failure::Unusable(format!(
            "{}; --size and --crop make it smaller, and a file of {} is written piece by piece",
            TooManyPixels {
                width: window.width,
                height: window.height,
            },
            able.join(", ")
        )))
    }

    /// Writes a picture whose bands `trace` hands out one after another, whole or not at all.
    pub(super) fn stream<T>(
        &self,
        window: &Window,
        watch: &Watch,
        trace: impl FnOnce(Deliver<'_>) -> Result<T, Failure>,
    ) -> Result<T, Failure> {
        let (Place::File(path) | Place::Stream(path)) = &self.place else {
            return Err(Failure::unusable("standard output takes no bands"));
        };
        let mut outcome = None;
        let write = || {
            write_whole(path, |out| {
                let mut out = Stoppable { out, watch };
                let mut bands = Bands::begin(window.width, window.height, &self.encoding, &mut out)?;
                let traced = trace(&mut |band| bands.push(band).map_err(|error| self.failed(&error, watch)));
                let complete = traced.is_ok();
                outcome = Some(traced);
                if complete {
                    bands.finish()
                } else {
                    Err(EncodeError::Io(io::Error::other("there is no picture")))
                }
            })
        };
        let written = match &self.place {
            Place::File(_) => while_writing(write),
            _ => write(),
        };
        match outcome {
            Some(Ok(traced)) => written.map(|()| traced).map_err(|error| self.failed(&error, watch)),
            Some(Err(failure)) => Err(failure),
            None => Err(written
                .err()
                .map_or(Failure::Interrupted, |error| self.failed(&error, watch))),
        }
    }

    fn failed(&self, error: &EncodeError, watch: &Watch) -> Failure {
        if watch.stopped() {
            Failure::Interrupted
        } else {
            Failure::Unusable(format!("cannot write {}: {error}", self.name()))
        }
    }

    /// Writes the picture, whole or not at all.
    pub(super) fn write(&self, picture: &Picture, watch: &Watch) -> Result<(), Failure> {
        let written = match &self.place {
            Place::File(path) => while_writing(|| self.save(path, picture, watch)),
            // Nothing is left behind here, and whoever reads may keep the writer waiting for ever.
            Place::Stream(path) => self.save(path, picture, watch),
            Place::Standard => self.pour(picture, watch),
        };
        written.map_err(|error| self.failed(&error, watch))
    }

    fn save(&self, path: &Path, picture: &Picture, watch: &Watch) -> Result<(), EncodeError> {
        write_whole(path, |out| {
            encode(picture, &self.encoding, &mut Stoppable { out, watch })
        })
    }

    /// To standard output, once all of it is there: some formats go back to fill in their header.
    fn pour(&self, picture: &Picture, watch: &Watch) -> Result<(), EncodeError> {
        let mut bytes = Cursor::new(Vec::new());
        encode(picture, &self.encoding, &mut bytes)?;
        let mut out = Stoppable {
            out: io::stdout().lock(),
            watch,
        };
        out.write_all(bytes.get_ref())?;
        out.flush()?;
        Ok(())
    }
}
