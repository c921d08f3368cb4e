//! A see-through picture to be laid over another one.

use image::codecs::png::PngEncoder;
use image::{ExtendedColorType, ImageEncoder};

use crate::EncodeError;

/// The bytes of a PNG file with an alpha channel. `pixels` are red, green, blue and opacity, each 0 to 255, row by row
/// from the top; `width * height` of them.
///
/// # Errors
/// `Codec` if there are more or fewer pixels than the size says, or none at all; `Memory` if the size is beyond memory.
pub fn overlay(width: u32, height: u32, pixels: &[[u8; 4]]) -> Result<Vec<u8>, EncodeError> {
    let wanted = usize::try_from(u64::from(width) * u64::from(height)).map_err(|_| EncodeError::Memory)?;
    if wanted == 0 || wanted != pixels.len() {
        let message = format!("{} pixels don't make a picture of {width} x {height}", pixels.len());
        return Err(EncodeError::Codec(message));
    }
    let mut bytes = Vec::new();
    PngEncoder::new(&mut bytes).write_image(pixels.as_flattened(), width, height, ExtendedColorType::Rgba8)?;
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use super::overlay;

    #[test]
    fn an_overlay_keeps_its_opacity() {
        let pixels = [[255, 0, 0, 255], [0, 0, 0, 0], [1, 2, 3, 4], [0, 255, 0, 128]];
        let bytes = overlay(2, 2, &pixels).unwrap();
        let read = image::load_from_memory(&bytes).unwrap();
        assert_eq!(read.color(), image::ColorType::Rgba8);
        assert_eq!(read.into_bytes(), pixels.as_flattened());
    }

    #[test]
    fn a_wrong_number_of_pixels_is_refused() {
        for (width, height, count) in [(2, 2, 3), (2, 2, 5), (0, 4, 0), (u32::MAX, u32::MAX, 1)] {
            assert!(
                overlay(width, height, &vec![[0; 4]; count]).is_err(),
                "{width} x {height}"
            );
        }
    }
}
