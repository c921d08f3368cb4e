//! Every case there is; the files themselves are in `tests/stability/`.

use super::{Case, CaseError};

macro_rules! cases {
    ($($name:literal)+) => {
        /// The files by name.
        const FILES: &[(&str, &str)] = &[$((
            $name,
            include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/stability/", $name, ".toml")),
        ),)+];
    };
}

cases! {
    "01-far-ball"
    "02-power-of-two"
    "03-power-of-ten"
    "04-tiny-ball"
    "05-far-from-the-origin"
    "06-telescope"
    "07-small-and-far"
    "08-flat-ellipsoid"
    "09-needle"
    "10-grazing"
    "11-tangent"
    "12-horizon"
    "13-parallel"
    "14-eye-on-surface"
    "15-long-chains"
    "16-strange-scales"
    "17-mirror-images"
    "18-less-itself"
    "19-with-itself"
    "20-glass-in-two-halves"
    "21-abutting-slabs"
    "22-laws-of-sets"
    "23-permuted-tree"
    "24-exit-of-a-union"
    "25-eye-in-a-half-space"
    "26-shell"
    "27-wedge"
    "28-holed-box"
    "29-deep-chain"
    "30-random-trees"
    "31-many-balls"
    "32-start-inside"
    "33-lit-cavity"
    "34-many-copies"
    "35-glass-ball"
    "36-critical-angle"
    "37-index-of-air"
    "38-strange-indices"
    "39-glass-in-water"
    "40-hundred-digits"
    "41-four-mirrors"
    "42-facing-mirrors"
    "43-corner-cube"
    "44-gain"
    "45-centre-of-a-mirror"
    "46-whispering-gallery"
    "47-shininess"
    "48-strange-shininess"
    "49-light-anywhere"
    "50-far-and-near-lights"
    "51-terminator"
    "52-many-lights"
    "53-strange-colours"
    "54-no-view"
    "55-along-up"
    "56-fields-of-view"
    "57-odd-sizes"
    "58-eye-within"
    "59-axis-rays"
    "60-devices"
    "61-ray-depths"
    "62-coplanar-turned"
    "63-needle-of-glass"
    "64-light-on-a-mirror"
    "65-touching-balls"
    "66-touching-nothing"
    "67-thin-lens"
    "68-mixed-scales"
    "69-dark-shares"
    "70-negative-mirror"
    "71-mirrors-64-deep"
    "72-huge-plane"
    "73-nearly-coincident"
    "74-inside-a-cone-of-planes"
    "75-glass-tower"
    "76-opposite-faces"
}

/// Reads every case, in the order of their names.
///
/// # Errors
/// If a file says something that no case does.
pub fn cases() -> Result<Vec<Case>, CaseError> {
    FILES.iter().map(|(name, text)| Case::read(name, text)).collect()
}

#[cfg(test)]
mod tests {
    use super::{FILES, cases};

    #[test]
    fn the_list_names_every_file_once_and_in_order() {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/stability");
        let mut files: Vec<String> = std::fs::read_dir(folder)
            .unwrap()
            .map(|entry| {
                entry
                    .unwrap()
                    .path()
                    .file_stem()
                    .unwrap()
                    .to_string_lossy()
                    .into_owned()
            })
            .collect();
        files.sort();
        let listed: Vec<_> = FILES.iter().map(|(name, _)| (*name).to_owned()).collect();
        assert_eq!(listed, files);
        assert_eq!(cases().unwrap().len(), files.len());
    }
}
