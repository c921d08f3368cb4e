//! Colours as the eye compares them.

/// Lightness, red against green, yellow against blue: the space Y Cx Cz, in which the eye's blur is known (Flohr et al.
/// 1992), of colours relative to the white of sRGB.
#[derive(Clone, Copy, Debug)]
pub(super) struct Opponent(pub(super) [f32; 3]);

/// Linear RGB of sRGB's primaries to XYZ (IEC 61966-2-1).
const TO_XYZ: [[f32; 3]; 3] = [
    [0.412_386_57, 0.357_591_5, 0.180_450_5],
    [0.212_636_82, 0.715_183, 0.072_180_2],
    [0.019_330_62, 0.119_197_17, 0.950_372_6],
];

/// The way back.
const FROM_XYZ: [[f32; 3]; 3] = [
    [3.241_003_3, -1.537_398_9, -0.498_615_87],
    [-0.969_224_33, 1.875_930_1, 0.041_554_224],
    [0.055_639_423, -0.204_011_2, 1.057_148_9],
];

/// XYZ of the white: the sums of the rows of [`TO_XYZ`].
const WHITE: [f32; 3] = [0.950_428_55, 1.0, 1.088_900_4];

impl Opponent {
    /// Of a component-wise encoded colour, as a screen shows it.
    pub(super) fn of_shown(colour: [f32; 3]) -> Self {
        let [x, y, z] = xyz(colour.map(decoded));
        Self([116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)])
    }

    /// In linear RGB, clamped to what a screen can show.
    pub(super) fn to_linear(self) -> [f32; 3] {
        let [lightness, cx, cz] = self.0;
        let y = (lightness + 16.0) / 116.0;
        let xyz = [(y + cx / 500.0) * WHITE[0], y, (y - cz / 200.0) * WHITE[2]];
        FROM_XYZ.map(|row| dot(row, xyz).clamp(0.0, 1.0))
    }
}

/// The paper's difference of two colours in linear RGB, 0 to 1: the distance HyAB (Abasi et al. 2020) in L*a*b* with
/// Hunt's adjustment, raised to 0.7, and spread so that most of the range is for the smaller ones.
pub(super) fn difference(first: [f32; 3], second: [f32; 3]) -> f32 {
    /// The exponent, and the point (of the greatest difference and of the range) where the slope changes.
    const EXPONENT: f32 = 0.7;
    const KNEE: (f32, f32) = (0.4, 0.95);
    let most = GREATEST.powf(EXPONENT);
    let knee = KNEE.0 * most;
    let power = hyab(adjusted(first), adjusted(second)).powf(EXPONENT);
    if power < knee {
        KNEE.1 / knee * power
    } else {
        (KNEE.1 + (power - knee) / (most - knee) * (1.0 - KNEE.1)).min(1.0)
    }
}

/// From the purest green to the purest blue; a test computes it.
const GREATEST: f32 = 203.301_67;

fn hyab(a: [f32; 3], b: [f32; 3]) -> f32 {
    (a[0] - b[0]).abs() + (a[1] - b[1]).hypot(a[2] - b[2])
}

/// L*a*b*, the colours of dark places less colourful (Hunt 1952).
fn adjusted(linear: [f32; 3]) -> [f32; 3] {
    const DELTA: f32 = 6.0 / 29.0;
    let [x, y, z] = xyz(linear).map(|value| {
        if value > DELTA * DELTA * DELTA {
            value.cbrt()
        } else {
            value / (3.0 * DELTA * DELTA) + 4.0 / 29.0
        }
    });
    let lightness = 116.0 * y - 16.0;
    let hunt = 0.01 * lightness;
    [lightness, 500.0 * (x - y) * hunt, 200.0 * (y - z) * hunt]
}

/// XYZ relative to white.
fn xyz(linear: [f32; 3]) -> [f32; 3] {
    let [x, y, z] = TO_XYZ.map(|row| dot(row, linear));
    [x / WHITE[0], y / WHITE[1], z / WHITE[2]]
}

fn dot(a: [f32; 3], b: [f32; 3]) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// A component through the curve of sRGB, backwards.
fn decoded(value: f32) -> f32 {
    let value = if value.is_nan() { 0.0 } else { value.clamp(0.0, 1.0) };
    if value <= 0.040_45 {
        value / 12.92
    } else {
        ((value + 0.055) / 1.055).powf(2.4)
    }
}

#[cfg(test)]
mod tests {
    use super::{FROM_XYZ, GREATEST, Opponent, TO_XYZ, WHITE, adjusted, dot, hyab};

    #[test]
    fn the_constants_belong_together() {
        let greatest = hyab(adjusted([0.0, 1.0, 0.0]), adjusted([0.0, 0.0, 1.0]));
        assert!((greatest - GREATEST).abs() < 1e-3, "{greatest}");
        for (index, row) in TO_XYZ.iter().enumerate() {
            assert!((row.iter().sum::<f32>() - WHITE[index]).abs() < 1e-6);
            let column = [0, 1, 2].map(|k| FROM_XYZ[k][index]);
            for (other, row) in TO_XYZ.iter().enumerate() {
                let unit = f32::from(u8::from(other == index));
                assert!((dot(*row, column) - unit).abs() < 1e-5, "{other} {index}");
            }
        }
    }

    #[test]
    fn a_colour_comes_back() {
        for colour in [[0.0; 3], [1.0; 3], [0.2, 0.9, 0.4], [1.0, 0.0, 0.01]] {
            let back = Opponent::of_shown(colour).to_linear();
            for (value, linear) in colour.iter().zip(back) {
                assert!((super::decoded(*value) - linear).abs() < 1e-5, "{colour:?} {back:?}");
            }
        }
    }
}
