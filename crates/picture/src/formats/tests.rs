//! Every format against itself.

use std::io::Cursor;
use std::path::Path;

use super::{Depth, Format};
use crate::{Encoding, Picture, Transfer, encode};

/// A picture whose values are no level's own, with a gentle course for the codec that smooths.
fn sample(width: u32, height: u32) -> Picture {
    let mut picture = Picture::black(width, height).unwrap();
    for (index, pixel) in picture.pixels_mut().iter_mut().enumerate() {
        let (x, y) = (index as u32 % width, index as u32 / width);
        *pixel = [
            x as f32 / 40.0 + 0.1003,
            y as f32 / 40.0 + 0.2003,
            (x + y) as f32 / 80.0 + 0.3001,
        ];
    }
    picture
}

fn check(format: Format, depth: Depth, width: u32, height: u32) {
    let picture = sample(width, height);
    let encoding = Encoding {
        depth: Some(depth),
        // For the float formats, to see that they hold the numbers unchanged.
        transfer: if depth == Depth::Float {
            Transfer::Srgb
        } else {
            Transfer::Linear
        },
        ..Encoding::of(format)
    };
    let mut file = Cursor::new(Vec::new());
    encode(&picture, &encoding, &mut file).unwrap();
    file.set_position(0);
    let back = if format.name() == "raw" {
        crate::load::read_raw(&mut file, width, height)
    } else {
        format.read(&mut file)
    };
    let back = back.unwrap_or_else(|error| panic!("{format} {depth}: {error}"));
    assert_eq!((back.width(), back.height()), (width, height), "{format}");
    let allowed = match (format.lossless(), depth) {
        (true, Depth::Eight) => 1.0 / 510.0 + 1e-7,
        (true, Depth::Sixteen) => 1.0 / 131_070.0 + 1e-7,
        (true, Depth::Float) => 0.0,
        // A byte of mantissa, shared: values up to 1 to the nearest 256th.
        (false, Depth::Float) => 1.0 / 512.0,
        (false, _) => 0.03,
    };
    for (a, b) in picture.pixels().iter().zip(back.pixels()) {
        for (a, b) in a.iter().zip(b) {
            assert!(
                (a - b).abs() <= allowed,
                "{format} {depth} {width}x{height}: {a} became {b}"
            );
        }
    }
}

#[test]
fn every_format_gives_back_what_it_took_at_every_depth() {
    for format in Format::all() {
        for &depth in format.depths() {
            for (width, height) in [(1, 1), (17, 13), (1, 9), (9, 1)] {
                check(format, depth, width, height);
            }
        }
    }
}

#[test]
fn floating_formats_hold_what_no_level_could() {
    let wild = [[-1.5, 1e30, 1e-30], [f32::INFINITY, f32::MAX, -0.0]];
    let mut picture = Picture::black(2, 1).unwrap();
    picture.pixels_mut().copy_from_slice(&wild);
    for name in ["pfm", "exr", "tiff"] {
        let format = Format::from_name(name).unwrap();
        let mut file = Cursor::new(Vec::new());
        let encoding = Encoding {
            depth: Some(Depth::Float),
            ..Encoding::of(format)
        };
        encode(&picture, &encoding, &mut file).unwrap();
        file.set_position(0);
        assert_eq!(format.read(&mut file).unwrap().pixels(), wild, "{name}");
    }
}

#[test]
fn names_and_extensions_lead_to_one_format() {
    for format in Format::all() {
        assert_eq!(Format::from_name(&format.name().to_uppercase()), Some(format));
        for extension in format.extensions() {
            let path = format!("a.b/{}.{extension}", "picture").to_uppercase();
            assert_eq!(Format::from_path(Path::new(&path)), Some(format));
        }
    }
    assert_eq!(Format::from_path(Path::new("png")), None);
    assert_eq!(Format::from_name("gif"), None);
}

#[test]
fn garbage_is_an_error_and_never_a_panic() {
    for format in Format::all() {
        for bytes in [&b""[..], b"PF\n4 4\n-1.0\nabc", b"P6 99999 99999 255 x", &[0xFF; 64]] {
            let mut file = Cursor::new(bytes);
            assert!(format.read(&mut file).is_err(), "{format} read {bytes:?}");
        }
    }
}
