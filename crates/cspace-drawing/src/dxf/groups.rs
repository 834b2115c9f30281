//! The pairs of a code and a value that a DXF file is made of, as text or binary.

use super::error::{DxfError, Result};

/// First bytes of a binary file.
const SENTINEL: &[u8] = b"AutoCAD Binary DXF\r\n\x1a\0";

/// Whether the bytes of a file are binary DXF.
pub(crate) fn is_binary(bytes: &[u8]) -> bool {
    bytes.starts_with(SENTINEL)
}

/// A code and its value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Group<'a> {
    pub(super) code: i32,
    pub(super) value: Value<'a>,
    /// The line of the code, counted from 1; in binary files the byte it is at.
    pub(super) line: usize,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Value<'a> {
    /// Text as it is written, without blanks around it.
    Text(&'a [u8]),
    Real(f64),
    Integer(i64),
}

impl<'a> Group<'a> {
    /// Bytes of a text; empty if the value is no text.
    pub(super) fn text(&self) -> &'a [u8] {
        match self.value {
            Value::Text(text) => text,
            _ => b"",
        }
    }

    /// Whether the group begins an item of this name.
    pub(super) fn begins(&self, name: &[u8]) -> bool {
        self.code == 0 && self.text() == name
    }

    /// A finite number.
    pub(super) fn real(&self) -> Result<f64> {
        let number = match self.value {
            Value::Real(x) => Some(x),
            Value::Integer(i) => Some(i as f64),
            Value::Text(text) => core::str::from_utf8(text)
                .ok()
                .and_then(|t| t.parse::<f64>().ok()),
        };
        number.filter(|x| x.is_finite()).ok_or_else(|| {
            let message = format!(
                "group {} is {} where a finite number is expected",
                self.code,
                self.shown()
            );
            DxfError::new(self.line, message, "export the drawing again")
        })
    }

    /// A whole number. Some programs write it as 1.0.
    pub(super) fn integer(&self) -> Result<i64> {
        let integer = match self.value {
            Value::Integer(i) => Some(i),
            Value::Real(x) => whole(x),
            Value::Text(text) => core::str::from_utf8(text).ok().and_then(|t| {
                let real = || t.parse::<f64>().ok().and_then(whole);
                t.parse::<i64>().ok().or_else(real)
            }),
        };
        integer.ok_or_else(|| {
            let message = format!(
                "group {} is {} where a whole number is expected",
                self.code,
                self.shown()
            );
            DxfError::new(self.line, message, "export the drawing again")
        })
    }

    fn shown(&self) -> String {
        /// Largest number of characters shown in a message.
        const LONGEST: usize = 40;
        match self.value {
            Value::Text(text) => {
                let text: String = String::from_utf8_lossy(text)
                    .chars()
                    .take(LONGEST)
                    .collect();
                format!("{text:?}")
            }
            Value::Real(x) => format!("{x:?}"),
            Value::Integer(i) => i.to_string(),
        }
    }
}

fn whole(x: f64) -> Option<i64> {
    (x.fract() == 0.0 && x.abs() < 1e15).then_some(x as i64)
}

/// The groups of a file, one after the other.
#[derive(Debug, Clone)]
pub(super) struct Groups<'a> {
    bytes: &'a [u8],
    at: usize,
    line: usize,
    form: Form,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Form {
    Text,
    /// Codes of one byte, or 255 and two more: R12 and before.
    ShortCodes,
    /// Codes of two bytes.
    LongCodes,
}

impl<'a> Groups<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        let (form, at) = match bytes.strip_prefix(SENTINEL) {
            // The first group is 0, SECTION: two bytes of zero are a code of two bytes.
            Some([0, 0, ..]) => (Form::LongCodes, SENTINEL.len()),
            Some(_) => (Form::ShortCodes, SENTINEL.len()),
            None if bytes.starts_with(b"\xef\xbb\xbf") => (Form::Text, 3),
            None => (Form::Text, 0),
        };
        Self {
            bytes,
            at,
            line: 1,
            form,
        }
    }

    /// Whether messages can name lines: binary files have none.
    pub(super) fn has_lines(&self) -> bool {
        self.form == Form::Text
    }

    /// The line that is read next, or the byte.
    pub(super) fn line(&self) -> usize {
        match self.form {
            Form::Text => self.line,
            _ => self.at,
        }
    }

    /// The next group; none at the end of the file.
    pub(super) fn next(&mut self) -> Result<Option<Group<'a>>> {
        match self.form {
            Form::Text => self.next_text(),
            Form::ShortCodes | Form::LongCodes => self.next_binary(),
        }
    }

    fn next_text(&mut self) -> Result<Option<Group<'a>>> {
        let line = self.line;
        let Some(code) = self.text_line() else {
            return Ok(None);
        };
        // Blank lines at the end are no group.
        if code.is_empty() && self.bytes[self.at..].iter().all(u8::is_ascii_whitespace) {
            return Ok(None);
        }
        let code = core::str::from_utf8(code)
            .ok()
            .and_then(|c| c.parse::<i32>().ok())
            .ok_or_else(|| no_code(line, code))?;
        let Some(text) = self.text_line() else {
            return Err(DxfError::cut_off(line));
        };
        Ok(Some(Group {
            code,
            value: Value::Text(text),
            line,
        }))
    }

    /// The next line without blanks around it.
    fn text_line(&mut self) -> Option<&'a [u8]> {
        let rest = self.bytes.get(self.at..).filter(|r| !r.is_empty())?;
        // Lines end in LF, CR LF or, of old, CR alone.
        let end = rest.iter().position(|&b| b == b'\n' || b == b'\r');
        let (text, used) = match end {
            Some(end) => {
                let both = rest[end] == b'\r' && rest.get(end + 1) == Some(&b'\n');
                (&rest[..end], end + 1 + usize::from(both))
            }
            None => (rest, rest.len()),
        };
        self.at += used;
        self.line += 1;
        Some(text.trim_ascii())
    }

    fn next_binary(&mut self) -> Result<Option<Group<'a>>> {
        let line = self.at;
        if self.at >= self.bytes.len() {
            return Ok(None);
        }
        let code = match self.form {
            Form::LongCodes => self.int::<2>()?,
            _ => match self.int::<1>()? {
                -1 => self.int::<2>()?,
                short => short & 0xff,
            },
        };
        let value = match code {
            10..=59 | 110..=149 | 210..=239 | 460..=469 | 1010..=1059 => {
                Value::Real(f64::from_le_bytes(self.array()?))
            }
            60..=79 | 170..=179 | 270..=289 | 370..=389 | 400..=409 | 1060..=1070 => {
                Value::Integer(self.int::<2>()?)
            }
            90..=99 | 420..=429 | 440..=459 | 1071 => Value::Integer(self.int::<4>()?),
            160..=169 => Value::Integer(i64::from_le_bytes(self.array()?)),
            290..=299 => Value::Integer(self.int::<1>()?),
            310..=319 | 1004 => {
                let length = self.int::<1>()? & 0xff;
                self.take(length as usize)?;
                Value::Text(b"")
            }
            0..=9
            | 100..=105
            | 300..=309
            | 320..=369
            | 390..=399
            | 410..=419
            | 430..=439
            | 470..=481
            | 999..=1009 => {
                let rest = &self.bytes[self.at..];
                let end =
                    (rest.iter().position(|&b| b == 0)).ok_or_else(|| DxfError::cut_off(line))?;
                self.at += end + 1;
                Value::Text(rest[..end].trim_ascii())
            }
            other => return Err(no_code(line, other.to_string().as_bytes())),
        };
        Ok(Some(Group {
            code: code as i32,
            value,
            line,
        }))
    }

    fn take(&mut self, count: usize) -> Result<&'a [u8]> {
        let taken =
            (self.bytes.get(self.at..self.at + count)).ok_or_else(|| DxfError::cut_off(self.at))?;
        self.at += count;
        Ok(taken)
    }

    fn array<const N: usize>(&mut self) -> Result<[u8; N]> {
        let mut array = [0; N];
        array.copy_from_slice(self.take(N)?);
        Ok(array)
    }

    /// Reads a signed integer of N bytes, little-endian.
    fn int<const N: usize>(&mut self) -> Result<i64> {
        let mut wide = [0; 8];
        wide[..N].copy_from_slice(&self.array::<N>()?);
        let unused = 64 - 8 * N;
        Ok((i64::from_le_bytes(wide) << unused) >> unused)
    }
}

fn no_code(line: usize, found: &[u8]) -> DxfError {
    let found: String = String::from_utf8_lossy(found).chars().take(40).collect();
    DxfError::new(
        line,
        format!("{found:?} where the code of a group is expected"),
        "a DXF file alternates lines of codes and of values: export the drawing again as DXF",
    )
}
