"""The same judge from any language that calls C, here Python's ctypes alone: python3 check.py LIBRARY"""
import ctypes
import sys

library = ctypes.CDLL(sys.argv[1] if len(sys.argv) > 1 else "libcircumspect.so.0")
library.circumspect_last_error.restype = ctypes.c_char_p
library.circumspect_verdict_text.restype = ctypes.c_char_p
library.circumspect_verdict_text.argtypes = [ctypes.c_void_p]
library.circumspect_verdict_holds.argtypes = [ctypes.c_void_p]
library.circumspect_verdict_free.argtypes = [ctypes.c_void_p]


class Mesh(ctypes.Structure):
    """circumspect_mesh of <circumspect/circumspect.h>."""

    _fields_ = [("struct_size", ctypes.c_size_t), ("dimension", ctypes.c_int64),
                ("point_count", ctypes.c_int64), ("coordinates", ctypes.c_void_p),
                ("exact_coordinates", ctypes.c_void_p), ("weights", ctypes.c_void_p),
                ("exact_weights", ctypes.c_void_p), ("simplex_count", ctypes.c_int64),
                ("vertices_of_simplex", ctypes.c_int64), ("index_bytes", ctypes.c_int64),
                ("simplices", ctypes.c_void_p), ("neighbors", ctypes.c_void_p),
                ("triangle_count", ctypes.c_int64), ("triangles", ctypes.c_void_p),
                ("edge_count", ctypes.c_int64), ("edges", ctypes.c_void_p)]


points = (ctypes.c_double * 8)(0, 0, 1, 0, 0, 1, 0.9, 0.9)
for rows, expected in (((0, 1, 3, 0, 3, 2), 1), ((0, 1, 2, 1, 3, 2), 0)):
    simplices = (ctypes.c_int32 * 6)(*rows)
    mesh = Mesh(struct_size=ctypes.sizeof(Mesh), dimension=2, point_count=4,
                coordinates=ctypes.addressof(points), simplex_count=2, vertices_of_simplex=3,
                index_bytes=4, simplices=ctypes.addressof(simplices))
    verdict = ctypes.c_void_p()
    if library.circumspect_check(b"delaunay", ctypes.byref(mesh), None, None, ctypes.byref(verdict)):
        sys.exit(library.circumspect_last_error().decode())
    print(library.circumspect_verdict_text(verdict).decode(), end="")
    if library.circumspect_verdict_holds(verdict) != expected:
        sys.exit("expected another answer")
    library.circumspect_verdict_free(verdict)
