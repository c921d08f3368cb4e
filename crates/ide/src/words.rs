//! Words for numbers, angles, colours and surfaces, and text from a file made safe for Markdown.

use scenec_scene::{DVec3, Material};
use scenec_syntax::quote;

/// A word or a statement of a file as Markdown code: cut short if it is long, and with nothing in it that could end the
/// code or the line.
pub(crate) fn code(text: &str) -> String {
    let plain = |character: char| match character {
        '`' => '\'',
        _ if character.is_control() => ' ',
        _ => character,
    };
    quote(&text.chars().take(200).map(plain).collect::<String>())
}

/// A message for Markdown: the words of a file in it stand between back ticks already, and everything else is escaped.
pub(crate) fn plain(message: &str) -> String {
    let mut in_code = false;
    let mut text = String::with_capacity(message.len());
    for character in message.chars() {
        in_code ^= character == '`';
        if !in_code && matches!(character, '\\' | '*' | '_' | '[' | ']' | '<' | '>' | '#' | '|' | '&') {
            text.push('\\');
        }
        text.push(if character.is_control() { ' ' } else { character });
    }
    text
}

/// A number, short enough to be read at a glance.
pub(crate) fn figure(value: f64) -> String {
    let size = value.abs();
    if value == 0.0 {
        return "0".to_owned();
    }
    if !(1e-3..1e6).contains(&size) {
        return format!("{value:.3e}");
    }
    let digits = match size {
        1000.0.. => 1,
        1.0.. => 3,
        _ => 4,
    };
    trim(&format!("{value:.digits$}"))
}

/// A point or a direction.
pub(crate) fn triple(v: DVec3) -> String {
    let v = settled(v, v.abs().max_element());
    format!("({}, {}, {})", figure(v.x), figure(v.y), figure(v.z))
}

/// The same without what rounding leaves of a zero among numbers of this size.
pub(crate) fn settled(v: DVec3, size: f64) -> DVec3 {
    let part = |part: f64| if part.abs() <= size * 1e-12 { 0.0 } else { part };
    DVec3::new(part(v.x), part(v.y), part(v.z))
}

/// Without the zeros at the end of a fraction.
pub(crate) fn trim(text: &str) -> String {
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        text.to_owned()
    }
}

/// An angle as a fraction of pi if it is one to within a few units in the last place, in degrees otherwise.
pub(crate) fn angle(radians: f64) -> String {
    pi_multiple(radians).unwrap_or_else(|| degrees(radians))
}

/// An angle in degrees.
pub(crate) fn degrees(radians: f64) -> String {
    let degrees = radians.to_degrees();
    if degrees.abs() < 1e6 {
        // Adding 0 makes a rounded -0 plain.
        let tenths = (degrees * 10.0).round() / 10.0 + 0.0;
        format!("{tenths}°")
    } else {
        format!("{degrees:.1e}°")
    }
}

/// A multiple of pi by a fraction with a small denominator, as in `3pi/4`.
pub(crate) fn pi_multiple(radians: f64) -> Option<String> {
    const LARGEST: f64 = 64.0;
    const DENOMINATORS: [u32; 13] = [1, 2, 3, 4, 5, 6, 8, 9, 10, 12, 16, 18, 36];
    let turns = radians / std::f64::consts::PI;
    if turns == 0.0 || turns.abs() > LARGEST {
        return None;
    }
    DENOMINATORS.into_iter().find_map(|under| {
        let over = (turns * f64::from(under)).round();
        let exact = over * std::f64::consts::PI / f64::from(under);
        let near = (exact - radians).abs() <= 4.0 * f64::EPSILON * radians.abs();
        (over != 0.0 && near).then(|| {
            let over = match over {
                1.0 => "pi".to_owned(),
                -1.0 => "-pi".to_owned(),
                _ => format!("{over}pi"),
            };
            if under == 1 { over } else { format!("{over}/{under}") }
        })
    })
}

/// A colour as editors write it, each part brought between 0 and 1 first.
pub(crate) fn hex(colour: DVec3) -> String {
    let [r, g, b] = bytes(colour.to_array());
    format!("#{r:02x}{g:02x}{b:02x}")
}

/// A colour in 8 bits a part, each brought between 0 and 1 first.
pub(crate) fn bytes(colour: [f64; 3]) -> [u8; 3] {
    // Between 0 and 255 after the clamp, so the cast is exact.
    colour.map(|part| (part.clamp(0.0, 1.0) * 255.0).round() as u8)
}

/// What a surface of this material looks like.
pub(crate) fn look(material: &Material) -> String {
    let mut words = vec![body(material)];
    if material.specular > 0.0 && material.reflect < 0.6 {
        words.push(match material.shiny {
            ..5.0 => "a very wide highlight",
            ..20.0 => "a wide highlight",
            ..100.0 => "a highlight",
            _ => "a small, sharp highlight",
        });
    }
    words.join(", ")
}

fn body(material: &Material) -> &'static str {
    let (reflect, refract) = (material.reflect, material.refract);
    match () {
        () if refract >= 0.5 && material.index == 1.0 => "clear, without bending light",
        () if refract >= 0.5 => "glass",
        () if reflect >= 0.6 => "a mirror",
        () if refract > 0.0 => "translucent",
        () if reflect >= 0.25 => "polished, mirroring its surroundings",
        () if reflect > 0.0 => "glossy, with a faint reflection",
        () if material.specular > 0.2 => "glossy",
        () if material.diffuse > 0.0 => "matt",
        () if material.ambient > 0.0 => "flat, as if it glowed",
        () => "black",
    }
}

#[cfg(test)]
mod tests {
    use super::{angle, code, figure};

    fn check(radians: f64, expect: &str) {
        assert_eq!(angle(radians), expect, "{radians}");
    }

    #[test]
    fn angles_are_fractions_of_pi_only_where_they_are() {
        let pi = std::f64::consts::PI;
        check(pi / 2.0, "pi/2");
        check(-pi * 3.0 / 4.0, "-3pi/4");
        check("0.7853981633974483".parse().unwrap(), "pi/4");
        check(2.0 * pi, "2pi");
        check(1.0, "57.3°");
        check("1.5708".parse().unwrap(), "90°");
        check(0.0, "0°");
        check(-1e-9, "0°");
        check(1e300, "5.7e301°");
    }

    #[test]
    fn figures_are_short() {
        let all = [0.0, 0.30000001, -2.5, 1e7, 0.000_012_345, 10.0, 1234.56];
        let found = all.map(figure).join(" ");
        assert_eq!(found, "0 0.3 -2.5 1.000e7 1.234e-5 10 1234.6");
    }

    #[test]
    fn words_of_a_file_stay_code() {
        assert_eq!(code("a`](http://x)<b>\n"), "`a'](http://x)<b> `");
        assert_eq!(code(&"é".repeat(999)).chars().count(), 43);
    }
}
