//! Judges two meshes of one square from Rust: one is Delaunay, the other is not. Exit code 0 if the judge says so.
//!     rustc -l circumspect check.rs && ./check
use std::ffi::{c_void, CStr, CString};
use std::os::raw::{c_char, c_int};
use std::ptr::{null, null_mut};

/// `circumspect_mesh` of <circumspect/circumspect.h>.
#[repr(C)]
struct Mesh {
    struct_size: usize,
    dimension: i64,
    point_count: i64,
    coordinates: *const f64,
    exact_coordinates: *const *const c_char,
    weights: *const f64,
    exact_weights: *const *const c_char,
    simplex_count: i64,
    vertices_of_simplex: i64,
    index_bytes: i64,
    simplices: *const c_void,
    neighbors: *const c_void,
    triangle_count: i64,
    triangles: *const i64,
    edge_count: i64,
    edges: *const i64,
}

extern "C" {
    fn circumspect_check(
        claim: *const c_char,
        mesh: *const Mesh,
        domain: *const c_void,
        options: *const c_void,
        verdict: *mut *mut c_void,
    ) -> c_int;
    fn circumspect_last_error() -> *const c_char;
    fn circumspect_verdict_holds(verdict: *const c_void) -> c_int;
    fn circumspect_verdict_text(verdict: *const c_void) -> *const c_char;
    fn circumspect_verdict_free(verdict: *mut c_void);
}

fn text(pointer: *const c_char) -> String {
    unsafe { CStr::from_ptr(pointer) }.to_string_lossy().into_owned()
}

/// Whether the triangles are the Delaunay triangulation of the points, and what is said about it; Err if the call is
/// wrong.
fn check(points: &[[f64; 2]], triangles: &[[i32; 3]]) -> Result<(bool, String), String> {
    let mesh = Mesh {
        struct_size: std::mem::size_of::<Mesh>(),
        dimension: 2,
        point_count: points.len() as i64,
        coordinates: points.as_ptr().cast(),
        exact_coordinates: null(),
        weights: null(),
        exact_weights: null(),
        simplex_count: triangles.len() as i64,
        vertices_of_simplex: 3,
        index_bytes: 4,
        simplices: triangles.as_ptr().cast(),
        neighbors: null(),
        triangle_count: 0,
        triangles: null(),
        edge_count: 0,
        edges: null(),
    };
    let claim = CString::new("delaunay").unwrap();
    let mut verdict = null_mut();
    unsafe {
        if circumspect_check(claim.as_ptr(), &mesh, null(), null(), &mut verdict) != 0 {
            return Err(text(circumspect_last_error()));
        }
        let answer = (circumspect_verdict_holds(verdict) == 1, text(circumspect_verdict_text(verdict)));
        circumspect_verdict_free(verdict);
        Ok(answer)
    }
}

fn main() -> Result<(), String> {
    // The last point is a little inside the circle of the others.
    let points = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.9, 0.9]];
    for (triangles, expected) in [([[0, 1, 3], [0, 3, 2]], true), ([[0, 1, 2], [1, 3, 2]], false)] {
        let (holds, said) = check(&points, &triangles)?;
        print!("{said}");
        if holds != expected {
            return Err("expected another answer".to_string());
        }
    }
    match check(&[[f64::NAN, 0.0]], &[]) {
        Err(fault) => println!("refused: {fault}"),
        Ok(_) => return Err("expected that NaN is refused".to_string()),
    }
    Ok(())
}
