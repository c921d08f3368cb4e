//! The pages of the rules as files, for findings to link to and editors to open.
//!
//! This owns their folder in the user's cache. A page that can't be kept there has no link, and nothing else suffers.

use std::collections::HashMap;
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::Mutex;

use scenec_device::cache_folder;
use scenec_ide::{Page, page};
use scenec_picture::write_whole;
use scenec_text::Code;
use tower_lsp::lsp_types::Url;

use crate::documents::lock;

/// The pages of this version of the program.
pub(crate) struct Pages {
    folder: Option<PathBuf>,
    /// Those that were asked for: each is looked after once.
    links: Mutex<HashMap<Code, Option<Url>>>,
}

impl Pages {
    /// Those of this user. Nothing is written before a page is asked for.
    pub(crate) fn of_user() -> Self {
        Self::within(cache_folder())
    }

    fn within(cache: Option<PathBuf>) -> Self {
        // A version has a folder of its own: servers of several may run at a time.
        let folder = |cache: PathBuf| cache.join("rules").join(env!("CARGO_PKG_VERSION"));
        Self {
            // An address can't be relative, and the variable that names the folder may be.
            folder: cache.and_then(|cache| std::path::absolute(folder(cache)).ok()),
            links: Mutex::default(),
        }
    }

    /// The address of a code's page, which is there. `None` where it can't be.
    pub(crate) fn link(&self, code: Code) -> Option<Url> {
        let mut links = lock(&self.links);
        let link = links.entry(code).or_insert_with(|| {
            let path = keep(self.folder.as_ref()?, &page(code)?).ok()?;
            Url::from_file_path(path).ok()
        });
        link.clone()
    }
}

/// Makes sure that a page lies in a folder.
fn keep(folder: &Path, page: &Page) -> io::Result<PathBuf> {
    let (path, text) = (folder.join(page.file_name()), page.whole());
    let there = || fs::read(&path).is_ok_and(|found| found == text.as_bytes());
    if !there() {
        let written =
            fs::create_dir_all(folder).and_then(|()| write_whole(&path, |out| out.write_all(text.as_bytes())));
        // Another server may be about the same: then what counts is that the page is there.
        written.or_else(|error| if there() { Ok(()) } else { Err(error) })?;
    }
    Ok(path)
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::path::{Path, PathBuf};
    use std::sync::Arc;
    use std::thread;

    use scenec_ide::page;
    use scenec_text::Code;

    use super::Pages;

    const CODE: Code = Code::AfterSubmission;

    /// A folder for one test, empty.
    fn scratch(name: &str) -> PathBuf {
        let folder = std::env::temp_dir().join(format!("scenec pages {} {name}", std::process::id()));
        fs::remove_dir_all(&folder).unwrap_or_default();
        folder
    }

    /// The file that a link leads to.
    fn linked(pages: &Pages) -> PathBuf {
        pages.link(CODE).unwrap().to_file_path().unwrap()
    }

    fn check_text(path: &Path) {
        assert_eq!(fs::read_to_string(path).unwrap(), page(CODE).unwrap().whole());
    }

    #[test]
    fn a_link_leads_to_the_page_whatever_the_folder_is_called() {
        let folder = scratch("größe 100% #1?");
        let pages = Pages::within(Some(folder.clone()));
        assert!(!folder.exists(), "nothing was asked for yet");
        let link = pages.link(CODE).unwrap();
        assert!(link.as_str().starts_with("file:///"), "{link}");
        assert!(link.as_str().contains("gr%C3%B6%C3%9Fe%20100%25%20%231"), "{link}");
        check_text(&linked(&pages));
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn a_page_that_is_another_one_is_replaced_and_one_that_is_right_is_left_alone() {
        let folder = scratch("replaced");
        let path = linked(&Pages::within(Some(folder.clone())));
        fs::write(&path, "half a pa").unwrap();
        assert_eq!(linked(&Pages::within(Some(folder.clone()))), path);
        check_text(&path);
        let written = fs::metadata(&path).unwrap().modified().unwrap();
        linked(&Pages::within(Some(folder.clone())));
        assert_eq!(fs::metadata(&path).unwrap().modified().unwrap(), written);
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn where_nothing_can_be_kept_there_is_no_link() {
        assert_eq!(Pages::within(None).link(CODE), None);
        let file = scratch("a file");
        fs::write(&file, "").unwrap();
        let pages = Pages::within(Some(file.clone()));
        assert_eq!(pages.link(CODE), None);
        fs::remove_file(file).unwrap();
        assert_eq!(pages.link(CODE), None, "a page is looked after once");
    }

    #[test]
    fn servers_do_not_get_into_each_others_way() {
        let folder = scratch("several");
        let folder = Arc::new(folder);
        let servers: Vec<_> = (0..8)
            .map(|_| {
                let folder = Arc::clone(&folder);
                thread::spawn(move || {
                    let pages = Pages::within(Some(folder.to_path_buf()));
                    Code::ALL.iter().filter(|code| pages.link(**code).is_some()).count()
                })
            })
            .collect();
        for server in servers {
            assert_eq!(server.join().unwrap(), Code::ALL.len());
        }
        let pages = Pages::within(Some(folder.to_path_buf()));
        let kept = fs::read_dir(linked(&pages).parent().unwrap()).unwrap().count();
        assert_eq!(kept, Code::ALL.len(), "nothing half-written is left");
        fs::remove_dir_all(&*folder).unwrap();
    }
}
