//! The functions of <circumspect/circumspect.h> that the crate calls.
use std::ffi::c_void;
use std::os::raw::{c_char, c_int};

#[repr(C)]
pub struct Mesh {
    pub struct_size: usize,
    pub dimension: i64,
    pub point_count: i64,
    pub coordinates: *const f64,
    pub exact_coordinates: *const *const c_char,
    pub weights: *const f64,
    pub exact_weights: *const *const c_char,
    pub simplex_count: i64,
    pub vertices_of_simplex: i64,
    pub index_bytes: i64,
    pub simplices: *const c_void,
    pub neighbors: *const c_void,
    pub triangle_count: i64,
    pub triangles: *const i64,
    pub edge_count: i64,
    pub edges: *const i64,
}

pub const OK: c_int = 0;
pub const INVALID_ARGUMENT: c_int = 1;
pub const INPUT_FAULT: c_int = 2;

extern "C" {
    pub fn circumspect_check(
        claim: *const c_char,
        mesh: *const Mesh,
        domain: *const c_void,
        options: *const c_void,
        verdict: *mut *mut c_void,
    ) -> c_int;
    pub fn circumspect_last_fault() -> *const c_char;
    pub fn circumspect_verdict_free(verdict: *mut c_void);
    pub fn circumspect_verdict_holds(verdict: *const c_void) -> c_int;
    pub fn circumspect_verdict_unique(verdict: *const c_void) -> c_int;
    pub fn circumspect_verdict_canonical(verdict: *const c_void) -> c_int;
    pub fn circumspect_verdict_text(verdict: *const c_void) -> *const c_char;
    pub fn circumspect_verdict_rule(verdict: *const c_void, index: i64, count: *mut i64) -> *const c_char;
    pub fn circumspect_generate(
        family: *const c_char,
        dimension: i64,
        points: i64,
        seed: u64,
        drawing: *mut *mut c_void,
    ) -> c_int;
    pub fn circumspect_drawing_mesh(drawing: *const c_void) -> *const Mesh;
    pub fn circumspect_drawing_free(drawing: *mut c_void);
    pub fn circumspect_orientation(dimension: i64, coordinates: *const f64, sign: *mut c_int) -> c_int;
    pub fn circumspect_in_ball(dimension: i64, coordinates: *const f64, sign: *mut c_int) -> c_int;
}
