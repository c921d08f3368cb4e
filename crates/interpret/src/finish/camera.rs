//! Whether the settings give a camera.

use scenec_scene::{DVec3, Settings, View, view};
use scenec_text::{Code, Diagnostic, Span};

use super::settings::known;
use crate::state::State;

const EYE: [&str; 3] = ["eyepos_x", "eyepos_y", "eyepos_z"];
const LOOKAT: [&str; 3] = ["lookat_x", "lookat_y", "lookat_z"];
const UP: [&str; 3] = ["up_x", "up_y", "up_z"];

/// Reports what keeps the camera from having a frame of its own, as far as the settings that tell are known.
pub(super) fn check(state: &mut State<'_>, settings: &Settings) {
    let [eye_known, lookat_known, up_known] = [EYE, LOOKAT, UP].map(|names| known(state, &names));
    let (eye, lookat, up) = (last_line(state, EYE), last_line(state, LOOKAT), last_line(state, UP));
    if up_known && settings.up == DVec3::ZERO {
        state.report(
            Diagnostic::new(
                Code::ZeroUp,
                "the up direction is zero",
                up,
                "`up_x`, `up_y` and `up_z` are all 0 here",
            )
            .help("remove the three to have y point up"),
        );
    }
    if !eye_known || !lookat_known {
        return;
    }
    let finding = match view(settings) {
        View::Clear(_) | View::NoUp => return,
        View::AlongUp(_) if !up_known => return,
        View::NoDirection if settings.eyepos == settings.lookat => Diagnostic::new(
            Code::EyeAtLookat,
            "the camera stands at the point that it looks at",
            eye,
            "the eye's last coordinate is set here",
        )
        .label(lookat, "and the last one of the point that it looks at here")
        .help("move `eyepos` or `lookat`"),
        View::NoDirection => Diagnostic::new(
            Code::SettingOutOfRange,
            "the camera is too far from the point that it looks at",
            eye,
            "the distance is larger than a double can hold",
        )
        .label(lookat, "the point that it looks at")
        .help("bring `eyepos` and `lookat` nearer to each other"),
        View::AlongUp(_) => Diagnostic::new(
            Code::UpAlongView,
            "the camera looks along its up direction",
            if up.is_empty() { eye } else { up },
            "another axis serves as up",
        )
        .help("set `up_x`, `up_y` and `up_z` to a direction across the view"),
    };
    state.report(finding);
}

/// The last of the lines that set these settings; empty if none does.
fn last_line(state: &State<'_>, names: [&str; 3]) -> Span {
    let lines = names
        .iter()
        .filter_map(|name| Some(state.variables.find(name)?.bound()?.line));
    lines.max_by_key(|line| line.start).unwrap_or_default()
}
