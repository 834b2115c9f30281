//! Spaces that took long to compute, kept in the user's folder of caches for the next command on the same pair.
//!
//! An entry is called by a hash of all that its space follows from. It holds a saved space, compressed, after a hash of that. Whatever
//! is wrong with an entry or the folder, the space is computed.

use std::io::{Read, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant, SystemTime};

use cspace::space::SAVED_VERSION;
use cspace::{Options, PairError, PairSpace, Part, Progress, Relation};
use cspace_model::saved;
use etcetera::BaseStrategy;
use flate2::Compression;
use flate2::read::GzDecoder;
use flate2::write::GzEncoder;
use sha2::{Digest, Sha256};

/// The variable that names the folder, or says that there is none.
const FOLDER: &str = "CSPACE_CACHE";

/// Value of [`FOLDER`] that turns the cache off.
const OFF: &str = "off";

/// The variable for the minimum computing time, in seconds, of the spaces that are kept.
const AFTER: &str = "CSPACE_CACHE_AFTER";

/// The minimum, if the variable is not set: a space that is computed faster takes longer to read.
const USUAL_AFTER: f64 = 0.2;

/// The bytes that all entries have together, at most.
const MOST: u64 = 512 << 20;

/// The bytes of one entry, at most, so that there is room for several.
const LARGEST: u64 = MOST / 4;

/// Ending of the file names of entries.
const ENDING: &str = ".cspace.gz";

/// Prefix of the names of files whose writing is not complete.
const UNFINISHED: &str = ".cspace-";

/// The space of two parts, and whether it was kept from before. One that is computed is kept.
pub(crate) fn space(
    keeps: bool,
    (fixed, moving): (&Part, &Part),
    relation: Relation,
    options: &Options,
    progress: &dyn Progress,
) -> Result<(PairSpace, bool), PairError> {
    let entry = match keeps {
        true => Entry::of(fixed, moving, relation, options),
        false => None,
    };
    if let Some(space) = entry.as_ref().and_then(Entry::read) {
        return Ok((space, true));
    }
    let begin = Instant::now();
    let space = PairSpace::compute_with(fixed, moving, relation, options, progress)?;
    if let Some(entry) = entry {
        entry.keep(&space, begin.elapsed());
    }
    Ok((space, false))
}

/// The place for the space of a pair.
struct Entry {
    path: PathBuf,
}

impl Entry {
    /// The place for the space of two parts; none where nothing is kept.
    fn of(fixed: &Part, moving: &Part, relation: Relation, options: &Options) -> Option<Self> {
        let folder = folder()?;
        let parts = serde_json::to_vec(&(fixed, moving)).ok()?;
        let key = Sha256::new()
            .chain_update(format!("{} {relation:?} {options:?} ", program()?))
            .chain_update(parts)
            .finalize();
        Some(Self {
            path: folder.join(hexadecimal(&key) + ENDING),
        })
    }

    /// The space, if it was kept and is whole.
    fn read(&self) -> Option<PairSpace> {
        let file = std::fs::File::open(&self.path).ok()?;
        let mut bytes = Vec::new();
        (&file).take(LARGEST).read_to_end(&mut bytes).ok()?;
        let (told, packed) = bytes.split_at_checked(Sha256::output_size())?;
        if *told != *Sha256::digest(packed) {
            return None;
        }
        let mut text = String::new();
        GzDecoder::new(packed).read_to_string(&mut text).ok()?;
        let space = saved::pair_from_json(&text, "").ok()?;
        // What is used is not the oldest. Where that cannot be said it is removed sooner.
        let _ = std::fs::File::options()
            .append(true)
            .open(&self.path)
            .and_then(|file| file.set_modified(SystemTime::now()));
        Some(space)
    }

    /// Keeps a space, if computing it took long enough. Where it cannot be written it is computed again the next time.
    fn keep(&self, space: &PairSpace, took: Duration) {
        if took.as_secs_f64() >= after() {
            let _ = self.write(space);
        }
    }

    fn write(&self, space: &PairSpace) -> std::io::Result<()> {
        let Some(folder) = self.path.parent() else {
            return Ok(());
        };
        std::fs::create_dir_all(folder)?;
        let mut packed = GzEncoder::new(Vec::new(), Compression::fast());
        packed.write_all(saved::pair_to_json(space).as_bytes())?;
        let packed = packed.finish()?;
        if packed.len() as u64 + Sha256::output_size() as u64 > LARGEST {
            return Ok(());
        }
        let mut file = tempfile::Builder::new()
            .prefix(UNFINISHED)
            .tempfile_in(folder)?;
        file.write_all(&Sha256::digest(&packed))?;
        file.write_all(&packed)?;
        file.persist(&self.path)?;
        bound(folder, MOST)
    }
}

/// The folder, if spaces are to be kept.
fn folder() -> Option<PathBuf> {
    match std::env::var_os(FOLDER).filter(|v| !v.is_empty()) {
        Some(value) if value == OFF => None,
        Some(folder) => Some(folder.into()),
        None => {
            let caches = etcetera::choose_base_strategy().ok()?.cache_dir();
            Some(caches.join("cspace").join("spaces"))
        }
    }
}

fn after() -> f64 {
    let given = std::env::var(AFTER).ok().and_then(|v| v.parse().ok());
    given.unwrap_or(USUAL_AFTER)
}

/// This build of the program: another may compute another space.
fn program() -> Option<String> {
    let file = std::env::current_exe().and_then(std::fs::metadata).ok()?;
    let built = file.modified().ok()?.duration_since(SystemTime::UNIX_EPOCH);
    Some(format!(
        "{} {SAVED_VERSION} {} {:?}",
        env!("CARGO_PKG_VERSION"),
        file.len(),
        built.ok()?
    ))
}

/// Removes the oldest entries until the rest has no more bytes than these; files that are no entries stay.
fn bound(folder: &Path, most: u64) -> std::io::Result<()> {
    let mut entries: Vec<(SystemTime, u64, PathBuf)> = Vec::new();
    for file in std::fs::read_dir(folder)? {
        let file = file?;
        let name = file.file_name();
        let is_entry = (name.to_str())
            .is_some_and(|name| name.ends_with(ENDING) || name.starts_with(UNFINISHED));
        if is_entry && let Ok(about) = file.metadata() {
            entries.push((about.modified()?, about.len(), file.path()));
        }
    }
    entries.sort();
    let mut all: u64 = entries.iter().map(|e| e.1).sum();
    for (_, bytes, path) in entries {
        if all <= most {
            break;
        }
        // Another command may have removed it.
        let _ = std::fs::remove_file(path);
        all -= bytes;
    }
    Ok(())
}

fn hexadecimal(bytes: &[u8]) -> String {
    bytes.iter().map(|b| format!("{b:02x}")).collect()
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::time::{Duration, SystemTime};

    use super::{ENDING, UNFINISHED, bound};

    /// Entries of 100 bytes, the first the oldest, and a file that is none.
    #[test]
    fn the_oldest_entries_are_removed_beyond_the_limit() {
        let folder = tempfile::tempdir().unwrap();
        let write = |name: &str, age: u64| {
            let file = fs::File::create(folder.path().join(name)).unwrap();
            file.set_len(100).unwrap();
            let then = SystemTime::now() - Duration::from_secs(age);
            file.set_modified(then).unwrap();
        };
        let names = ["a", "b", "c", "d"].map(|name| format!("{name}{ENDING}"));
        for (name, age) in names.iter().zip([50, 40, 30, 20]) {
            write(name, age);
        }
        let unfinished = format!("{UNFINISHED}e");
        write(&unfinished, 60);
        write("notes.txt", 1000);
        let left = || {
            let files = fs::read_dir(folder.path()).unwrap();
            let mut names: Vec<String> = files
                .map(|file| file.unwrap().file_name().into_string().unwrap())
                .collect();
            names.sort();
            names
        };
        let all = left();
        bound(folder.path(), 500).unwrap();
        assert_eq!(left(), all);
        bound(folder.path(), 499).unwrap();
        assert!(!left().contains(&unfinished));
        assert_eq!(left().len(), 5);
        bound(folder.path(), 250).unwrap();
        assert_eq!(left(), [&names[2], &names[3], "notes.txt"]);
        bound(folder.path(), 0).unwrap();
        assert_eq!(left(), ["notes.txt"]);
    }
}
