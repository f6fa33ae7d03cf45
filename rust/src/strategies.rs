//! Strategies of proptest that draw points from the families of degenerate and nearly degenerate sets.
//!
//! ```
//! use proptest::prelude::*;
//! let strategy = circumspect::strategies::points::<2>(&circumspect::strategies::FAMILIES, 20);
//! # let _ = strategy;
//! ```
use proptest::prelude::*;
use proptest::sample;

/// Families where programs go wrong; `circumspect generate --list` prints all.
pub const FAMILIES: [&str; 9] = [
    "uniform",
    "integers",
    "grid",
    "clusters",
    "collinear",
    "lower-dimensional",
    "grid+ulp",
    "lower-dimensional+ulp",
    "sphere+ulp",
];

/// More than D and at most `most` points of one of the families, as far as the family has so many; they shrink by leaving points
/// out.
///
/// # Panics
/// When a value is drawn: a family that does not exist, or not in the dimension.
pub fn points<const D: usize>(families: &[&'static str], most: usize) -> impl Strategy<Value = Vec<[f64; D]>> {
    let family = sample::select(families.to_vec()).no_shrink();
    (family, any::<u64>().no_shrink(), D + 1..=most.max(D + 1)).prop_flat_map(|(family, seed, count)| {
        let rows = crate::generate::<D>(family, count, seed).unwrap_or_else(|error| panic!("{error}"));
        let all = rows.len();
        sample::subsequence(rows, all.min(D + 1)..=all)
    })
}
