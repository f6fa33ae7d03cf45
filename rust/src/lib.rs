//! The exact oracle for triangulations: it judges what your program made of points, and gives a witness.
//!
//! ```
//! let points = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.9, 0.9]];
//! circumspect::assert_delaunay!(points, [[0, 1, 3], [0, 3, 2]]);
//! ```
//!
//! Nothing is rounded, and no tolerance affects a verdict. Points are rows of doubles, simplices rows of indices from 0, and
//! neither is copied.

mod c;
#[cfg(feature = "proptest")]
pub mod strategies;

use std::collections::BTreeMap;
use std::error;
use std::ffi::{c_void, CStr, CString};
use std::fmt;
use std::os::raw::{c_char, c_int};
use std::ptr::{null, null_mut};

/// Why there is no answer.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Error {
    /// The call is wrong: an unknown claim.
    Call(String),
    /// The input is at fault, not the mesh: equal points, a coordinate that is not finite.
    Input(String),
    /// No memory, no answer.
    Other(String),
}

impl fmt::Display for Error {
    fn fmt(&self, to: &mut fmt::Formatter) -> fmt::Result {
        let (Error::Call(text) | Error::Input(text) | Error::Other(text)) = self;
        to.write_str(text)
    }
}

impl error::Error for Error {}

/// What was judged.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Verdict {
    pub holds: bool,
    /// Of a Delaunay claim that holds: is there no other such triangulation?
    pub unique: Option<bool>,
    /// Of a Delaunay claim that holds: is it the one in which ties are broken canonically?
    pub canonical: Option<bool>,
    /// How often each broken rule is broken.
    pub rules: BTreeMap<String, i64>,
    /// What the command would print: each witness, then one line.
    pub text: String,
}

/// Integers that simplices list points by. One that names no point is a fault of the mesh.
///
/// # Safety
/// The type is an integer of 4 or 8 bytes.
pub unsafe trait Index: Copy {}
unsafe impl Index for i32 {}
unsafe impl Index for u32 {}
unsafe impl Index for i64 {}
unsafe impl Index for u64 {}
#[cfg(any(target_pointer_width = "32", target_pointer_width = "64"))]
unsafe impl Index for usize {}

fn owned(text: *const c_char) -> String {
    unsafe { CStr::from_ptr(text) }.to_string_lossy().into_owned()
}

fn demand(status: c_int) -> Result<(), Error> {
    if status == c::OK {
        return Ok(());
    }
    // Without advice: the crate has no options.
    let text = owned(unsafe { c::circumspect_last_fault() });
    Err(match status {
        c::INVALID_ARGUMENT => Error::Call(text),
        c::INPUT_FAULT => Error::Input(text),
        _ => Error::Other(text),
    })
}

fn c_text(text: &str) -> Result<CString, Error> {
    CString::new(text).map_err(|_| Error::Call(format!("expected a name without a zero byte, found {text:?}")))
}

/// What the library holds, until it is given back.
struct Held(*mut c_void, unsafe extern "C" fn(*mut c_void));

impl Drop for Held {
    fn drop(&mut self) {
        unsafe { self.1(self.0) }
    }
}

/// Judges, exactly, a claim about a mesh: "delaunay", "triangulation" or "complex".
///
/// # Errors
/// An unknown claim is [`Error::Call`]; equal points, numbers that are not finite and a mesh without points and simplices are
/// [`Error::Input`].
pub fn check<const D: usize, const K: usize, I: Index>(
    claim: &str,
    points: &[[f64; D]],
    simplices: &[[I; K]],
) -> Result<Verdict, Error> {
    let claim = c_text(claim)?;
    let mesh = c::Mesh {
        struct_size: std::mem::size_of::<c::Mesh>(),
        dimension: D as i64,
        point_count: points.len() as i64,
        coordinates: points.as_ptr().cast(),
        exact_coordinates: null(),
        weights: null(),
        exact_weights: null(),
        simplex_count: simplices.len() as i64,
        vertices_of_simplex: K as i64,
        index_bytes: std::mem::size_of::<I>() as i64,
        simplices: simplices.as_ptr().cast(),
        neighbors: null(),
        triangle_count: 0,
        triangles: null(),
        edge_count: 0,
        edges: null(),
    };
    let mut verdict = null_mut();
    demand(unsafe { c::circumspect_check(claim.as_ptr(), &mesh, null(), null(), &mut verdict) })?;
    let verdict = Held(verdict, c::circumspect_verdict_free);
    let fact = |value| if value < 0 { None } else { Some(value == 1) };
    let mut rules = BTreeMap::new();
    for index in 0.. {
        let mut count = 0;
        let rule = unsafe { c::circumspect_verdict_rule(verdict.0, index, &mut count) };
        if rule.is_null() {
            break;
        }
        rules.insert(owned(rule), count);
    }
    Ok(unsafe {
        Verdict {
            holds: c::circumspect_verdict_holds(verdict.0) == 1,
            unique: fact(c::circumspect_verdict_unique(verdict.0)),
            canonical: fact(c::circumspect_verdict_canonical(verdict.0)),
            rules,
            text: owned(c::circumspect_verdict_text(verdict.0)),
        }
    })
}

/// The points that a seed stands for, the same on every machine: those of `circumspect generate FAMILY`.
///
/// # Errors
/// [`Error::Call`]: there is no such family, or not in that dimension, or `count` is not from 1 to 1,000,000.
pub fn generate<const D: usize>(family: &str, count: usize, seed: u64) -> Result<Vec<[f64; D]>, Error> {
    let family = c_text(family)?;
    let mut drawing = null_mut();
    demand(unsafe { c::circumspect_generate(family.as_ptr(), D as i64, count as i64, seed, &mut drawing) })?;
    let drawing = Held(drawing, c::circumspect_drawing_free);
    let mesh = unsafe { &*c::circumspect_drawing_mesh(drawing.0) };
    if mesh.point_count == 0 {
        return Ok(Vec::new());
    }
    let rows: *const [f64; D] = mesh.coordinates.cast();
    Ok(unsafe { std::slice::from_raw_parts(rows, mesh.point_count as usize) }.to_vec())
}

/// The sign of det(p0 − pd, …), of D + 1 points: in the plane 1 if they turn counterclockwise.
///
/// # Errors
/// [`Error::Call`]: another number of points; [`Error::Input`]: a coordinate that is not finite.
pub fn orient<const D: usize>(points: &[[f64; D]]) -> Result<i32, Error> {
    signed(points, D + 1, c::circumspect_orientation)
}

/// Is the last of D + 2 points inside (1), on (0) or outside (−1) the sphere through the others?
///
/// # Errors
/// As [`orient`]; [`Error::Input`] also if the others are affinely dependent.
pub fn in_ball<const D: usize>(points: &[[f64; D]]) -> Result<i32, Error> {
    signed(points, D + 2, c::circumspect_in_ball)
}

fn signed<const D: usize>(
    points: &[[f64; D]],
    count: usize,
    predicate: unsafe extern "C" fn(i64, *const f64, *mut c_int) -> c_int,
) -> Result<i32, Error> {
    if points.len() != count {
        return Err(Error::Call(format!("expected {count} points, found {}", points.len())));
    }
    let mut sign = 0;
    demand(unsafe { predicate(D as i64, points.as_ptr().cast(), &mut sign) })?;
    Ok(sign)
}

/// Panics, with the witnesses, unless the claim holds.
#[track_caller]
pub fn assert_holds<const D: usize, const K: usize, I: Index>(claim: &str, points: &[[f64; D]], simplices: &[[I; K]]) {
    match check(claim, points, simplices) {
        Ok(verdict) => assert!(verdict.holds, "{}", verdict.text),
        Err(error) => panic!("{error}"),
    }
}

/// Panics, with the witnesses, unless the simplices are a Delaunay triangulation of the points.
#[macro_export]
macro_rules! assert_delaunay {
    ($points:expr, $simplices:expr $(,)?) => {
        $crate::assert_holds("delaunay", &$points[..], &$simplices[..])
    };
}

/// Panics, with the witnesses, unless the simplices are a triangulation of the points.
#[macro_export]
macro_rules! assert_triangulation {
    ($points:expr, $simplices:expr $(,)?) => {
        $crate::assert_holds("triangulation", &$points[..], &$simplices[..])
    };
}
