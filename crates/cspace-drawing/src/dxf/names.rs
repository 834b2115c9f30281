//! Texts of a DXF file: their encoding, and one copy of each.

use std::borrow::Cow;
use std::collections::HashMap;
use std::sync::Arc;

#[cfg(feature = "encodings")]
use encoding_rs::{Encoding, UTF_8};

/// Texts that entities share.
pub(super) struct Names<'a> {
    #[cfg(feature = "encodings")]
    encoding: &'static Encoding,
    known: HashMap<&'a [u8], Arc<str>>,
    empty: Arc<str>,
}

impl<'a> Names<'a> {
    pub(super) fn new() -> Self {
        Self {
            #[cfg(feature = "encodings")]
            encoding: UTF_8,
            known: HashMap::new(),
            empty: Arc::from(""),
        }
    }

    /// Sets the encoding named in the header's `$DWGCODEPAGE`, with the feature `encodings`. Files of R2007 and later
    /// are always in UTF-8.
    #[cfg_attr(not(feature = "encodings"), allow(clippy::unused_self))]
    pub(super) fn set_code_page(&mut self, page: &[u8]) {
        #[cfg(not(feature = "encodings"))]
        let _ = page;
        #[cfg(feature = "encodings")]
        self.follow(page);
    }

    #[cfg(feature = "encodings")]
    fn follow(&mut self, page: &[u8]) {
        let page = String::from_utf8_lossy(page).to_ascii_lowercase();
        let number = page.trim_start_matches("ansi_").trim_start_matches("dos");
        let label = match number {
            "932" => "shift_jis",
            "936" => "gbk",
            "949" => "euc-kr",
            "950" => "big5",
            "874" => "windows-874",
            "866" => "ibm866",
            number => &format!("windows-{number}"),
        };
        if let Some(encoding) = Encoding::for_label(label.as_bytes()) {
            self.encoding = encoding;
        }
    }

    /// The text; the same one for the same bytes.
    pub(super) fn get(&mut self, bytes: &'a [u8]) -> Arc<str> {
        if bytes.is_empty() {
            return Arc::clone(&self.empty);
        }
        if let Some(name) = self.known.get(bytes) {
            return Arc::clone(name);
        }
        let name: Arc<str> = self.decoded(bytes).into();
        self.known.insert(bytes, Arc::clone(&name));
        name
    }

    /// A text that no other entity has.
    pub(super) fn own(&self, bytes: &[u8]) -> Arc<str> {
        if bytes.is_empty() {
            return Arc::clone(&self.empty);
        }
        self.decoded(bytes).into()
    }

    fn decoded(&self, bytes: &[u8]) -> String {
        let text: Cow<'_, str> = match core::str::from_utf8(bytes) {
            Ok(text) => text.into(),
            #[cfg(feature = "encodings")]
            Err(_) => self.encoding.decode_without_bom_handling(bytes).0,
            #[cfg(not(feature = "encodings"))]
            Err(_) => bytes.iter().map(|b| char::from(*b)).collect(),
        };
        unescaped(&text)
    }
}

/// The text with `\U+00E4` as the character that it stands for.
fn unescaped(text: &str) -> String {
    let mut parts = text.split("\\U+");
    let mut out = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let digits = part.get(..4);
        let code = digits.and_then(|d| u32::from_str_radix(d, 16).ok());
        match code.and_then(char::from_u32) {
            Some(c) => {
                out.push(c);
                out.push_str(&part[4..]);
            }
            None => {
                out.push_str("\\U+");
                out.push_str(part);
            }
        }
    }
    out
}

/// Names of layers and blocks are the same in capitals and small letters.
pub(super) fn folded(name: &str) -> String {
    name.to_lowercase()
}
