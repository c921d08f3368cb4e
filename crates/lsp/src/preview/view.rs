//! What is looked at: a wish about size and camera, and the settings that come of it.

use scenec_scene::{DVec3, Settings, View, setting, view};

use super::words::{CameraUsed, Look};

/// A preview has no more pixels than this: 16 million are more than any panel shows.
const MOST_PIXELS: f64 = (1 << 24) as f64;

/// The settings of a picture: the file's, with the camera that is wished for and no larger than is wished for.
///
/// # Errors
/// A sentence for people, for a camera that sees nothing.
pub(super) fn settings(file: &Settings, look: &Look) -> Result<Settings, String> {
    let mut settings = file.clone();
    if let Some(wish) = look.camera {
        settings.eyepos = DVec3::from_array(wish.eye);
        settings.lookat = DVec3::from_array(wish.lookat);
        settings.up = wish.up.map_or(settings.up, DVec3::from_array);
        settings.fov = wish.fov.unwrap_or(settings.fov);
    }
    let finite = [settings.eyepos, settings.lookat, settings.up]
        .iter()
        .all(|vector| vector.is_finite());
    let range = setting("fov").map(|row| row.range);
    if !finite || !range.is_some_and(|range| range.holds(settings.fov)) {
        return Err("the camera is given by numbers that it can't have".to_owned());
    }
    (settings.width, settings.height) = size((settings.width, settings.height), look.size);
    match view(&settings) {
        View::Clear(_) | View::AlongUp(_) => Ok(settings),
        View::NoDirection => Err("the camera stands where it looks".to_owned()),
        View::NoUp => Err("the camera's up direction is zero".to_owned()),
    }
}

/// The largest size of the same shape that is no larger than the file's, than what is wished for, or than a preview may
/// be.
fn size((width, height): (u32, u32), most: Option<(u32, u32)>) -> (u32, u32) {
    let (w, h) = (f64::from(width.max(1)), f64::from(height.max(1)));
    let (most_w, most_h) = most.map_or((w, h), |(w, h)| (f64::from(w), f64::from(h)));
    let part = (most_w / w)
        .min(most_h / h)
        .min((MOST_PIXELS / (w * h)).sqrt())
        .min(1.0);
    // Between 1 and the file's own size, hence exact.
    let side = |side: f64| (side * part).round().max(1.0) as u32;
    (side(w), side(h))
}

/// The camera of these settings.
pub(super) fn camera(settings: &Settings) -> CameraUsed {
    CameraUsed {
        eye: settings.eyepos.to_array(),
        lookat: settings.lookat.to_array(),
        up: settings.up.to_array(),
        fov: settings.fov,
    }
}

#[cfg(test)]
mod tests {
    use scenec_scene::{DVec3, Settings};

    use super::{settings, size};
    use crate::preview::{CameraWish, Look};

    fn file() -> Settings {
        let mut file = Settings::gather(|_| None);
        (file.width, file.height, file.eyepos) = (600, 400, DVec3::X);
        file
    }

    /// `expect` is the camera's place, or a part of the error.
    fn check(camera: Option<CameraWish>, expect: Result<DVec3, &str>) {
        let look = Look {
            name: String::new(),
            size: Some((300, 300)),
            camera,
            ignore_operators: false,
        };
        match (settings(&file(), &look), expect) {
            (Ok(settings), Ok(eye)) => {
                assert_eq!((settings.eyepos, settings.width, settings.height), (eye, 300, 200));
            }
            (Err(error), Err(part)) => assert!(error.contains(part), "{camera:?}: {error}"),
            (got, expect) => panic!("{camera:?}: {got:?} instead of {expect:?}"),
        }
    }

    #[test]
    fn a_camera_takes_the_place_of_the_files_if_it_sees() {
        let wish = |eye, lookat| CameraWish {
            eye,
            lookat,
            up: None,
            fov: None,
        };
        let plain = wish([0.0, 2.0, 5.0], [0.0; 3]);
        check(None, Ok(DVec3::X));
        check(Some(plain), Ok(DVec3::new(0.0, 2.0, 5.0)));
        check(Some(wish([0.0, 5.0, 0.0], [0.0; 3])), Ok(DVec3::Y * 5.0));
        check(Some(wish([1.0; 3], [1.0; 3])), Err("stands where it looks"));
        check(Some(wish([f64::NAN; 3], [1.0; 3])), Err("can't have"));
        check(Some(wish([f64::INFINITY, 0.0, 0.0], [1.0; 3])), Err("can't have"));
        check(
            Some(CameraWish {
                up: Some([0.0; 3]),
                ..plain
            }),
            Err("up direction is zero"),
        );
        for fov in [0.0, 4.0, f64::NAN] {
            check(
                Some(CameraWish {
                    fov: Some(fov),
                    ..plain
                }),
                Err("can't have"),
            );
        }
    }

    #[test]
    fn the_shape_is_kept_and_nothing_is_blown_up() {
        for (file, most, expect) in [
            ((600, 400), None, (600, 400)),
            ((600, 400), Some((1200, 1200)), (600, 400)),
            ((600, 400), Some((300, 1000)), (300, 200)),
            ((600, 400), Some((1000, 100)), (150, 100)),
            ((600, 400), Some((0, 0)), (1, 1)),
            ((65535, 1), Some((100, 100)), (100, 1)),
            ((65535, 65535), None, (4096, 4096)),
        ] {
            assert_eq!(size(file, most), expect, "{file:?} {most:?}");
        }
    }
}
