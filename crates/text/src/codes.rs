//! The table of diagnostic codes: one row each, stable once released.

/// How grave a finding is.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Severity {
    /// The file means nothing until it is mended.
    Error,
    /// The file means something, but perhaps not what its author believes.
    Warning,
    /// A remark.
    Hint,
}

macro_rules! codes {
    ($($(#[doc = $doc:literal])+ $name:ident = $id:literal, $severity:ident;)+) => {
        /// What was found. The identifier never changes its meaning once released.
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
        pub enum Code {
            $($(#[doc = $doc])+ $name,)+
        }

        impl Code {
            /// Every code, in the order of the table.
            pub const ALL: &[Self] = &[$(Self::$name,)+];

            /// The identifier that people and suppressions use, such as `E005`.
            #[must_use]
            pub const fn id(self) -> &'static str {
                match self { $(Self::$name => $id,)+ }
            }

            /// How grave it is.
            #[must_use]
            pub const fn severity(self) -> Severity {
                match self { $(Self::$name => Severity::$severity,)+ }
            }

            /// What the rule looks for, in one line.
            #[must_use]
            pub fn summary(self) -> &'static str {
                match self { $(Self::$name => concat!($($doc,)+).trim_ascii(),)+ }
            }
        }
    };
}

codes! {
    /// Bytes that are not UTF-8.
    InvalidUtf8 = "E001", Error;
    /// A character that the language has no use for.
    UnexpectedCharacter = "E002", Error;
    /// A number that is not written as one.
    MalformedNumber = "E003", Error;
    /// A number too large for a double.
    NumberOverflow = "E004", Error;
    /// A line that fits no statement.
    UnexpectedToken = "E005", Error;
    /// A statement with values missing.
    TooFewValues = "E006", Error;
    /// A statement with words left over.
    TooManyValues = "E007", Error;
    /// A base object that is neither `sphere` nor `hp`.
    UnknownBase = "E008", Error;
    /// An assignment to the constant `pi`.
    AssignedConstant = "E009", Error;
    /// A transform of a combination.
    TransformedCombination = "E010", Error;
    /// A setting outside its range.
    SettingOutOfRange = "E011", Error;
    /// A scale by zero.
    ZeroScale = "E012", Error;
    /// A negative shininess.
    NegativeShininess = "E013", Error;
    /// Settings that the file never gives.
    MissingSettings = "E014", Error;
    /// A file that submits no object.
    MissingSubmission = "E015", Error;
    /// Both spellings of one setting.
    SettingTwice = "E016", Error;
    /// An eye that stands where it looks.
    EyeAtLookat = "E017", Error;
    /// An up direction of length zero.
    ZeroUp = "E018", Error;
    /// A transform that leaves the range of a double.
    TransformOverflow = "E019", Error;
    /// A number so small that it reads as zero.
    NumberUnderflow = "W001", Warning;
    /// A statement ignored because it names an object that does not exist.
    UnknownObject = "W002", Warning;
    /// A statement ignored because it names a material that does not exist.
    UnknownMaterial = "W003", Warning;
    /// A statement ignored because it names a variable that does not exist.
    UnknownVariable = "W004", Warning;
    /// An object statement after the submission.
    AfterSubmission = "W005", Warning;
    /// A material redefined after an object took it.
    MaterialRedefined = "W006", Warning;
    /// An object edited after a combination took it.
    OperandEdited = "W007", Warning;
    /// A name bound again before anything used it.
    OverwrittenUnused = "W008", Warning;
    /// A variable that nothing reads.
    UnusedVariable = "W009", Warning;
    /// A view direction along the up direction.
    UpAlongView = "W010", Warning;
    /// An index of refraction that bends light as no glass does.
    StrangeIndex = "W011", Warning;
    /// An object that no part of the picture uses.
    UnusedObject = "W012", Warning;
    /// A material that no object takes.
    UnusedMaterial = "W013", Warning;
    /// A transform by nothing.
    IdleTransform = "W014", Warning;
    /// A transform that turns or stretches an object into itself.
    EffectlessTransform = "W015", Warning;
    /// A material of an object that another one replaces before anything used it.
    MaterialReplaced = "W016", Warning;
    /// A material that gives back more light than it gets.
    EnergyGain = "W017", Warning;
    /// A negative share of light in a material.
    NegativeCoefficient = "W018", Warning;
    /// A material's colour outside 0 to 1.
    ColourOutOfRange = "W019", Warning;
    /// A light or an ambient light of negative colour.
    NegativeLight = "W020", Warning;
    /// A highlight in a scene without a light.
    LostHighlight = "W021", Warning;
    /// A rotation that looks like degrees.
    LikelyDegrees = "W022", Warning;
    /// A picture that takes a great deal of memory.
    HugePicture = "W023", Warning;
    /// Mirrors or glass in a scene that follows no ray on.
    LostReflection = "W024", Warning;
    /// A light that is black.
    DarkLight = "W025", Warning;
    /// A solid that another one of its union contains.
    CoveredSolid = "W040", Warning;
    /// A subtraction that removes nothing.
    IdleSubtraction = "W041", Warning;
    /// A subtraction that removes everything.
    EmptySubtraction = "W042", Warning;
    /// An intersection of solids that have nothing in common.
    EmptyIntersection = "W043", Warning;
    /// An intersection with a solid that cuts nothing away.
    IdleIntersection = "W044", Warning;
    /// A solid combined with itself.
    CoincidentOperands = "W045", Warning;
    /// A light inside an opaque solid.
    BuriedLight = "W046", Warning;
    /// An eye inside an opaque solid.
    BuriedEye = "W047", Warning;
    /// A picture in which nothing can be seen.
    NothingInView = "W048", Warning;
    /// A transform that stretches far more one way than another.
    IllConditioned = "W049", Warning;
    /// An object too far from the eye to be told from its neighbours in numbers of 32 bits.
    TooFarToResolve = "W050", Warning;
    /// A comment that silences nothing.
    UselessAllow = "I001", Hint;
    /// A refraction that bends nothing.
    UnbentGlass = "I002", Hint;
    /// A great many sample points.
    ManySamples = "I003", Hint;
    /// A ray depth that no material uses.
    IdleDepth = "I004", Hint;
}

#[cfg(test)]
mod tests {
    use super::{Code, Severity};

    #[test]
    fn identifiers_are_unique_and_tell_the_severity() {
        for (i, code) in Code::ALL.iter().enumerate() {
            let letter = match code.severity() {
                Severity::Error => 'E',
                Severity::Warning => 'W',
                Severity::Hint => 'I',
            };
            assert!(code.id().starts_with(letter), "{code:?}");
            assert!(Code::ALL[..i].iter().all(|other| other.id() != code.id()), "{code:?}");
            assert!(code.summary().ends_with('.'), "{code:?}");
        }
    }
}
