// The polynomials behind orientation and in-sphere tests, each written once: evaluated with doubles
// by the filters, with integers by the exact stages, and with terms by the test that writes the
// Gappa scripts of proofs/filters. So a bound is proved for exactly the operations that run, in the
// same order. Book: Section 3.1 (Orient2D, Orient3D, InCircle, InSphere), Section 5.2 (heights of
// weighted points).
//
// All are polynomials in differences: a row is a point minus the last vertex of the simplex, c or
// d. They are always inlined, because a call takes as long as half of the operations.
#pragma once

namespace circumspect::fast {

// Height of a row above the origin of differences: the paraboloid.
template <typename T>
[[gnu::always_inline]] inline auto height(const T& x, const T& y) {
  return x * x + y * y;
}
template <typename T>
[[gnu::always_inline]] inline auto height(const T& x, const T& y, const T& z) {
  return (x * x + y * y) + z * z;
}

// det[a; b], rows with two entries: Orient2D.
template <typename T, typename U>
[[gnu::always_inline]] inline auto minor(const T& a0, const U& a1, const T& b0, const U& b1) {
  return a0 * b1 - a1 * b0;
}

// One row of a matrix: a point minus the last vertex, and its height above it.
template <typename T, typename H>
struct Row2 {
  T x, y;
  H w;
};
template <typename T, typename H>
struct Row3 {
  T x, y, z;
  H w;
};

// The cofactors of the query's row in InCircle. They depend on the triangle alone.
template <typename XY, typename XW>
struct TriangleCofactors {
  XY xy;  // twice the signed area: Orient2D
  XW xw, yw;
};
template <typename XY, typename XW>
TriangleCofactors(XY, XW, XW) -> TriangleCofactors<XY, XW>;

template <typename T, typename H>
[[gnu::always_inline]] inline auto cofactors(const Row2<T, H>& a, const Row2<T, H>& b) {
  return TriangleCofactors{minor(a.x, a.y, b.x, b.y), minor(a.x, a.w, b.x, b.w),
                           minor(a.y, a.w, b.y, b.w)};
}

// −det[a; b; q]: for a counterclockwise triangle positive iff q is below its witness plane.
template <typename XY, typename XW, typename T, typename H>
[[gnu::always_inline]] inline auto in_circle(const TriangleCofactors<XY, XW>& c,
                                             const Row2<T, H>& q) {
  return (q.y * c.xw - q.x * c.yw) - q.w * c.xy;
}

// A determinant with rows a, b, c, along its last or (which gives the same sign) its first column.
template <typename T, typename M>
[[gnu::always_inline]] inline auto along_column(const T& a, const T& b, const T& c, const M& bc,
                                                const M& ac, const M& ab) {
  return (a * bc - b * ac) + c * ab;
}

// det[a; b; c], rows with three entries: Orient3D.
template <typename T, typename H>
[[gnu::always_inline]] inline auto volume(const Row3<T, H>& a, const Row3<T, H>& b,
                                          const Row3<T, H>& c) {
  return along_column(a.z, b.z, c.z, minor(b.x, b.y, c.x, c.y), minor(a.x, a.y, c.x, c.y),
                      minor(a.x, a.y, b.x, b.y));
}

// The cofactors of the query's row in InSphere. They depend on the tetrahedron alone.
template <typename XYZ, typename XYW, typename XZW>
struct TetrahedronCofactors {
  XYZ xyz;  // six times the signed volume: Orient3D, by the operations of `volume`
  XYW xyw;
  XZW xzw, yzw;
};
template <typename XYZ, typename XYW, typename XZW>
TetrahedronCofactors(XYZ, XYW, XZW, XZW) -> TetrahedronCofactors<XYZ, XYW, XZW>;

template <typename T, typename H>
[[gnu::always_inline]] inline auto cofactors(const Row3<T, H>& a, const Row3<T, H>& b,
                                             const Row3<T, H>& c) {
  const auto xy_bc = minor(b.x, b.y, c.x, c.y);
  const auto xy_ac = minor(a.x, a.y, c.x, c.y);
  const auto xy_ab = minor(a.x, a.y, b.x, b.y);
  const auto zw_bc = minor(b.z, b.w, c.z, c.w);
  const auto zw_ac = minor(a.z, a.w, c.z, c.w);
  const auto zw_ab = minor(a.z, a.w, b.z, b.w);
  return TetrahedronCofactors{along_column(a.z, b.z, c.z, xy_bc, xy_ac, xy_ab),
                              along_column(a.w, b.w, c.w, xy_bc, xy_ac, xy_ab),
                              along_column(a.x, b.x, c.x, zw_bc, zw_ac, zw_ab),
                              along_column(a.y, b.y, c.y, zw_bc, zw_ac, zw_ab)};
}

// −det[a; b; c; q]: for a positive tetrahedron positive iff q is below its witness hyperplane.
template <typename XYZ, typename XYW, typename XZW, typename T, typename H>
[[gnu::always_inline]] inline auto in_sphere(const TetrahedronCofactors<XYZ, XYW, XZW>& c,
                                             const Row3<T, H>& q) {
  return ((q.x * c.yzw - q.y * c.xzw) + q.z * c.xyw) - q.w * c.xyz;
}

}  // namespace circumspect::fast
