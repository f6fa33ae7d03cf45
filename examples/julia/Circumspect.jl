# The exact oracle for triangulations, over the C library. Written by Julia's manual: nobody has run it yet.
#
#     include("Circumspect.jl")
#     points = [0.0 1 0 0.9; 0.0 0 1 0.9]   # a column a point
#     Circumspect.assert_delaunay(points, [1 2; 2 4; 3 3])   # throws, with the witness
module Circumspect

const library = get(ENV, "CIRCUMSPECT_LIBRARY", "libcircumspect")

# circumspect_mesh of <circumspect/circumspect.h>
struct Mesh
    struct_size::Csize_t
    dimension::Int64
    point_count::Int64
    coordinates::Ptr{Cdouble}
    exact_coordinates::Ptr{Cvoid}
    weights::Ptr{Cdouble}
    exact_weights::Ptr{Cvoid}
    simplex_count::Int64
    vertices_of_simplex::Int64
    index_bytes::Int64
    simplices::Ptr{Cvoid}
    neighbors::Ptr{Cvoid}
    triangle_count::Int64
    triangles::Ptr{Int64}
    edge_count::Int64
    edges::Ptr{Int64}
end

demand(status) = status == 0 || throw(ArgumentError(unsafe_string(@ccall library.circumspect_last_fault()::Cstring)))

# The columns as doubles; a number that is none is not rounded, but refused.
function doubles(points)
    columns = Matrix{Cdouble}(points)
    isequal(columns, points) || throw(ArgumentError("expected coordinates that are doubles, found one that would be rounded"))
    columns
end

"""
    check(points, simplices; claim = "delaunay") -> (holds, text)

Judges a claim exactly. `points` has a column for each point, `simplices` one for each simplex, with indices from 1. `text` is what the
command prints, which counts from 0.
"""
function check(points::AbstractMatrix{<:Real}, simplices::AbstractMatrix{<:Integer}; claim::AbstractString = "delaunay")
    coordinates, indices = doubles(points), Matrix{Int64}(simplices) .- 1
    verdict = Ref{Ptr{Cvoid}}(C_NULL)
    GC.@preserve coordinates indices begin
        mesh = Ref(Mesh(sizeof(Mesh), size(coordinates, 1), size(coordinates, 2), pointer(coordinates), C_NULL, C_NULL, C_NULL,
                        size(indices, 2), size(indices, 1), 8, pointer(indices), C_NULL, 0, C_NULL, 0, C_NULL))
        demand(@ccall library.circumspect_check(claim::Cstring, mesh::Ref{Mesh}, C_NULL::Ptr{Cvoid}, C_NULL::Ptr{Cvoid},
                                                verdict::Ref{Ptr{Cvoid}})::Cint)
    end
    try
        holds = (@ccall library.circumspect_verdict_holds(verdict[]::Ptr{Cvoid})::Cint) == 1
        (holds, unsafe_string(@ccall library.circumspect_verdict_text(verdict[]::Ptr{Cvoid})::Cstring))
    finally
        @ccall library.circumspect_verdict_free(verdict[]::Ptr{Cvoid})::Cvoid
    end
end

"Throws, with the witness, unless the mesh is a Delaunay triangulation of the points."
function assert_delaunay(points, simplices)
    holds, text = check(points, simplices)
    holds || throw(ErrorException(text))
end

end
