//! Edits of a text that was right.

use core::ops::Range;

use super::bases::BASES;
use crate::draw::Bytes;

/// The most edits of one text.
const MOST: usize = 6;

/// Replacements for a number, or any place of a text.
const ODD: [&str; 44] = [
    "nan",
    "inf",
    "-inf",
    "-0.0",
    "0",
    "-1",
    "1e400",
    "1e308",
    "-1e308",
    "1e150",
    "1e-320",
    "4294967296",
    "9223372036854775808",
    "-9223372036854775809",
    "18446744073709551616",
    "1e6",
    "1000001",
    "\"18deg\"",
    "\"1e309deg\"",
    "\"deg\"",
    "\"nan rad\"",
    "\"\"",
    "\"\\u0007\"",
    "\"\u{202e}\"",
    "[]",
    "[[]]",
    "{}",
    "null",
    "true",
    "0x10",
    "1_0",
    ",",
    "]",
    "[",
    "}",
    "\"",
    "\n",
    "\u{feff}",
    "\0",
    "[[part]]\n",
    "[[pair]]\n",
    "[[joint]]\n",
    "motion = { type = \"planar\" }\n",
    "symmetry = 3\n",
];

/// Chooses one of the texts and makes some edits.
pub(super) fn edited(bytes: &mut Bytes<'_>) -> String {
    let chosen = bytes.below(BASES.len());
    let mut text = BASES[chosen].clone().into_bytes();
    edit_some(&mut text, bytes);
    String::from_utf8_lossy(&text).into_owned()
}

/// Makes some edits.
pub(crate) fn edit_some(text: &mut Vec<u8>, bytes: &mut Bytes<'_>) {
    for _ in 0..=bytes.below(MOST) {
        edit(text, bytes);
    }
}

fn edit(text: &mut Vec<u8>, bytes: &mut Bytes<'_>) {
    let place = |bytes: &mut Bytes<'_>| (bytes.share() * text.len() as f64) as usize;
    let at = place(bytes).min(text.len());
    let other = place(bytes).min(text.len());
    let odd = bytes.one_of(&ODD).bytes();
    let short = at..(at + 1 + bytes.below(16)).min(text.len());
    match bytes.below(8) {
        0 => {
            text.splice(short, odd);
        }
        1 => {
            text.splice(at..at, odd);
        }
        2 => {
            text.drain(short);
        }
        3 => {
            let copy = text[short].to_vec();
            text.splice(other..other, copy);
        }
        4 => {
            let copy = text[line(text, at)].to_vec();
            let there = line(text, other).start;
            text.splice(there..there, copy);
        }
        5 => {
            let gone = line(text, at);
            text.drain(gone);
        }
        6 if bytes.below(4) == 0 => text.truncate(at),
        _ => {
            if let Some(number) = number(text, at) {
                text.splice(number, odd);
            }
        }
    }
}

/// The line about a place, its end included.
fn line(text: &[u8], at: usize) -> Range<usize> {
    let start = text[..at]
        .iter()
        .rposition(|&c| c == b'\n')
        .map_or(0, |i| i + 1);
    let end = text[at..]
        .iter()
        .position(|&c| c == b'\n')
        .map_or(text.len(), |i| at + i + 1);
    start..end
}

/// The first number from a place on.
fn number(text: &[u8], at: usize) -> Option<Range<usize>> {
    let is_part = |c: &u8| c.is_ascii_digit() || b"+-.eE".contains(c);
    let start = at + text[at..].iter().position(u8::is_ascii_digit)?;
    let end = text[start..]
        .iter()
        .position(|c| !is_part(c))
        .map_or(text.len(), |n| start + n);
    Some(start..end)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edits_find_lines_and_numbers() {
        let text = b"ab = 1\nc = -2.5e3]\n";
        assert_eq!(line(text, 0), 0..7);
        assert_eq!(line(text, 9), 7..19);
        assert_eq!(number(text, 7), Some(12..17));
        assert_eq!(number(text, 18), None);
    }
}
