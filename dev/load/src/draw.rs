//! Numbered random pairs.

use cspace::{Part, PartError};
use cspace_oracle::{Case, Family, families};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

use crate::outline::{Loops, negative, outline};

/// Name for outlines that favour ties, beside those of the families.
pub const TIES: &str = "ties";

/// Share of outlines that favour ties among all pairs; the others are of the families.
const SHARE_OF_TIES: f64 = 0.75;

/// Number of attempts to draw an outline that is a part, before the pair counts as refused.
const ATTEMPTS: usize = 20;

/// Endless list of pairs: deterministic for a seed, each given by its number.
#[derive(Debug, Clone)]
pub struct Source {
    seed: u64,
    families: Vec<Family>,
    ties: bool,
}

/// Pair drawn from the list.
#[derive(Debug, Clone)]
pub struct Drawn {
    /// The family, and the value of its number.
    pub name: String,
    /// The pair, or why its outlines are no parts.
    pub case: Result<Case, PartError>,
    /// Randomness that belongs to the pair.
    pub rng: ChaCha8Rng,
}

impl Source {
    /// The pairs of a seed, all of them or of one family; `None` if there is no family of that name.
    pub fn new(seed: u64, family: Option<&str>) -> Option<Self> {
        let mut all = families();
        let ties = match family {
            Some(TIES) => {
                all.clear();
                true
            }
            Some(name) => {
                all.retain(|f| f.name == name);
                false
            }
            None => true,
        };
        (ties || !all.is_empty()).then_some(Self {
            seed,
            families: all,
            ties,
        })
    }

    /// The pair of a number.
    pub fn draw(&self, number: u64) -> Drawn {
        let mut rng = ChaCha8Rng::seed_from_u64(self.seed);
        rng.set_stream(number);
        if self.families.is_empty() || self.ties && rng.random_bool(SHARE_OF_TIES) {
            let case = ties(&mut rng);
            return Drawn {
                name: TIES.into(),
                case,
                rng,
            };
        }
        let family = &self.families[rng.random_range(0..self.families.len())];
        let value = family.draw(&mut rng);
        Drawn {
            name: format!("{} {value:e}", family.name),
            case: family.build(value),
            rng,
        }
    }
}

/// Two outlines that favour ties; the one perhaps the negative of the other, or the same.
///
/// # Errors
/// Reports the error of the last of several outlines if none of them is a part.
pub fn ties(rng: &mut impl Rng) -> Result<Case, PartError> {
    let moving = accepted("moving", rng, outline)?;
    let loops: Loops = moving
        .loops()
        .iter()
        .map(|l| l.vertices().to_vec())
        .collect();
    let fixed = match rng.random_range(0..10) {
        0 | 1 => accepted("fixed", rng, |rng| negative(&loops, rng))?,
        2 => Part::new("fixed", loops)?,
        _ => accepted("fixed", rng, outline)?,
    };
    Ok(Case {
        fixed,
        moving,
        window: None,
        notable: Vec::new(),
    })
}

/// First of some outlines that is a part, or the error of the last.
fn accepted<R: Rng>(
    name: &str,
    rng: &mut R,
    draw: impl Fn(&mut R) -> Loops,
) -> Result<Part, PartError> {
    let mut last = PartError::Empty;
    for _ in 0..ATTEMPTS {
        match Part::new(name, draw(rng)) {
            Ok(part) => return Ok(part),
            Err(error) => last = error,
        }
    }
    Err(last)
}
