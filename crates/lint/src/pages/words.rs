//! Bytes, characters and numbers.

use crate::page::Page;

pub(super) const PAGES: &[Page] = &[
    page! {
        /// The file holds bytes that are not UTF-8, the encoding of every scene file.
        ///
        /// Most often the file was saved in an older encoding, such as Latin-1, with a letter beyond ASCII in a comment.
        /// The rest of the file is checked all the same. Save it as UTF-8; in the examples here, `\xE9` stands for the
        /// single byte that Latin-1 has for é.
        ///
        /// ## Example
        ///
        /// ```scene
        /// !ball := sphere / caf\xE9
        /// !ball <=
        /// ```
        ///
        /// ## Fixed
        ///
        /// ```scene
        /// !ball := sphere / café
        /// !ball <=
        /// ```
        InvalidUtf8
    },
    page! {
        /// A character that stands for nothing in the language.
        ///
        /// Names hold letters, digits and `_`. A comment begins with `/`. A carriage return without a line feed ends no
        /// line.
        ///
        /// ## Example
        ///
        /// ```scene
        /// !ball := sphere;
        /// !ball <=
        /// ```
        ///
        /// ## Fixed
        ///
        /// ```scene
        /// !ball := sphere
        /// !ball <=
        /// ```
        UnexpectedCharacter
    },
    page! {
        /// Something that begins like a number but is none: two points, an exponent without digits, letters behind the
        /// digits.
        ///
        /// A number has digits with at most one point, and may end in an exponent: `2`, `.5`, `2.`, `6.02e23`. A name
        /// can't begin with a digit.
        ///
        /// ## Example
        ///
        /// ```scene
        /// !ball := sphere
        /// !ball += 1.2.3 0 0
        /// !ball <=
        /// ```
        ///
        /// ## Fixed
        ///
        /// ```scene
        /// !ball := sphere
        /// !ball += 1.23 0 0
        /// !ball <=
        /// ```
        MalformedNumber
    },
    page! {
        /// A number beyond what a double holds, which is about 1.8e308.
        ///
        /// ## Example
        ///
        /// ```scene
        /// !ball := sphere
        /// !ball += 1e999 0 0
        /// !ball <=
        /// ```
        ///
        /// ## Fixed
        ///
        /// ```scene
        /// !ball := sphere
        /// !ball += 1e-9 0 0
        /// !ball <=
        /// ```
        NumberOverflow
    },
    page! {
        /// A number that is not zero as it is written, but so small that the nearest double is.
        ///
        /// It is read as 0. The smallest double above 0 is about 4.9e-324.
        ///
        /// ## Example
        ///
        /// ```scene
        /// !ball := sphere
        /// !ball += 1 1e-999 0
        /// !ball <=
        /// ```
        ///
        /// ## Fixed
        ///
        /// ```scene
        /// !ball := sphere
        /// !ball += 1 0 0
        /// !ball <=
        /// ```
        NumberUnderflow
    },
];
