//! How a picture is cut up: into bands of rows, which threads take, and those into tiles, whose rays run close together
//! and so meet the same parts of the scene.

use std::ops::Range;

use scenec_picture::{Exact, NOTHING, Picture, Spread};
use scenec_plan::packed_structs::Leaf;
use scenec_plan::{Real, in_doubles, in_singles};

use crate::lanes::LANES;
use crate::pixel::Pixel;

/// A tile has about this many samples, so that progress and a stop are noticed soon and handing out costs nothing.
const TILE_SAMPLES: usize = 1024;

/// The most rows of a band.
const MOST_ROWS: usize = 8;

/// There are to be this many bands for each thread, so that none waits long for the last.
const BANDS_PER_THREAD: usize = 16;

/// Some rows of a window and where their pixels go.
pub(crate) struct Band<'a> {
    first_row: usize,
    columns: usize,
    tile_columns: usize,
    picture: &'a mut [[f32; 3]],
    ids: Option<&'a mut [u32]>,
    exact: Option<&'a mut [[f64; 3]]>,
    spread: Option<&'a mut [Spread]>,
    distances: Option<&'a mut [f64]>,
}

/// A rectangle of a window's pixels.
#[derive(Clone, Debug)]
pub(crate) struct Tile {
    pub(crate) columns: Range<u32>,
    pub(crate) rows: Range<u32>,
}

impl Tile {
    /// How many pixels it has.
    pub(crate) fn pixels(&self) -> usize {
        self.columns.len() * self.rows.len()
    }
}

/// What is wanted beside the picture, pixel by pixel.
pub(crate) struct Layers<'a> {
    pub(crate) ids: Option<&'a mut Vec<u32>>,
    pub(crate) exact: Option<&'a mut Exact>,
    pub(crate) spread: Option<&'a mut Vec<Spread>>,
    pub(crate) distances: Option<&'a mut Vec<f64>>,
}

/// Cuts a window up for so many threads, where each pixel has so many samples.
pub(crate) fn bands<'a>(picture: &'a mut Picture, layers: Layers<'a>, threads: usize, samples: usize) -> Vec<Band<'a>> {
    let (columns, rows) = (picture.width() as usize, picture.height() as usize);
    // Never fewer than are followed at once.
    let pixels = (TILE_SAMPLES / samples.max(1)).max(LANES);
    let band_rows = MOST_ROWS
        .min(pixels.isqrt())
        .min(rows / (threads * BANDS_PER_THREAD))
        .max(1);
    let run = band_rows * columns;
    let mut ids = layers.ids.map(|ids| ids.chunks_mut(run));
    let mut exact = layers.exact.map(|exact| exact.chunks_mut(run));
    let mut spread = layers.spread.map(|spread| spread.chunks_mut(run));
    let mut distances = layers.distances.map(|distances| distances.chunks_mut(run));
    let bands = picture.pixels_mut().chunks_mut(run).enumerate();
    bands
        .map(|(i, picture)| Band {
            first_row: i * band_rows,
            columns,
            tile_columns: (pixels / band_rows).clamp(1, 2 * MOST_ROWS),
            picture,
            ids: ids.as_mut().and_then(Iterator::next),
            exact: exact.as_mut().and_then(Iterator::next),
            spread: spread.as_mut().and_then(Iterator::next),
            distances: distances.as_mut().and_then(Iterator::next),
        })
        .collect()
}

impl Band<'_> {
    /// Its tiles from left to right.
    pub(crate) fn tiles(&self) -> impl Iterator<Item = Tile> + use<> {
        let (first, rows, columns) = (self.first_row, self.picture.len() / self.columns, self.columns);
        (0..columns).step_by(self.tile_columns).map({
            let width = self.tile_columns;
            move |left| Tile {
                columns: left as u32..(left + width).min(columns) as u32,
                rows: first as u32..(first + rows) as u32,
            }
        })
    }

    /// Puts the pixels of a tile, row by row, where they belong.
    pub(crate) fn store<R: Real>(&mut self, tile: &Tile, pixels: &[Pixel<R>], leaves: &[Leaf]) {
        let width = tile.columns.len();
        for (row, pixels) in pixels.chunks(width).enumerate() {
            let start = row * self.columns + tile.columns.start as usize;
            let here = start..start + width;
            put(&mut self.picture[here.clone()], pixels, |pixel| {
                in_singles(pixel.colour)
            });
            if let Some(ids) = &mut self.ids {
                put(&mut ids[here.clone()], pixels, |pixel| {
                    leaves.get(pixel.leaf as usize).map_or(NOTHING, |leaf| leaf.solid)
                });
            }
            if let Some(exact) = &mut self.exact {
                put(&mut exact[here.clone()], pixels, |pixel| in_doubles(pixel.colour));
            }
            if let Some(spread) = &mut self.spread {
                put(&mut spread[here.clone()], pixels, |pixel| pixel.spread);
            }
            if let Some(distances) = &mut self.distances {
                put(&mut distances[here], pixels, |pixel| pixel.distance.to_f64());
            }
        }
    }
}

fn put<T, R>(to: &mut [T], pixels: &[Pixel<R>], value: impl Fn(&Pixel<R>) -> T) {
    for (to, pixel) in to.iter_mut().zip(pixels) {
        *to = value(pixel);
    }
}

#[cfg(test)]
mod tests {
    use scenec_picture::Picture;

    use scenec_plan::packed_structs::Leaf;

    use super::{Layers, bands};
    use crate::pixel::Pixel;

    fn check(width: u32, height: u32, threads: usize, samples: usize) {
        let mut picture = Picture::black(width, height).unwrap();
        let mut ids = vec![u32::MAX; picture.pixels().len()];
        let leaf = |solid: u32| Leaf {
            solid,
            ..Leaf::default()
        };
        let leaves: Vec<_> = (0..width * height).map(leaf).collect();
        let layers = Layers {
            ids: Some(&mut ids),
            exact: None,
            spread: None,
            distances: None,
        };
        for mut band in bands(&mut picture, layers, threads, samples) {
            for tile in band.tiles() {
                let number = |row: u32| tile.columns.clone().map(move |column| row * width + column);
                let pixels: Vec<_> = tile.rows.clone().flat_map(number).collect();
                assert_eq!(pixels.len(), tile.pixels());
                let pixels: Vec<_> = pixels
                    .into_iter()
                    .map(|leaf| Pixel::<f32> {
                        leaf,
                        ..Pixel::default()
                    })
                    .collect();
                band.store(&tile, &pixels, &leaves);
            }
        }
        assert_eq!(ids, (0..width * height).collect::<Vec<_>>(), "{width} x {height}");
    }

    #[test]
    fn every_pixel_comes_to_its_place() {
        for (width, height) in [(1, 1), (17, 13), (1, 300), (300, 1), (640, 360)] {
            for (threads, samples) in [(1, 1), (2, 9), (64, 4096)] {
                check(width, height, threads, samples);
            }
        }
    }
}
