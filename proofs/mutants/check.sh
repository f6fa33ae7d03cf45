#!/bin/bash
# Holds circumspect-verified to the first line of each certificate here, and the certificates to
# make.py, and quick-test to what it prints of some:  proofs/mutants/check.sh PROGRAM QUICK-TEST
set -euo pipefail
program=$(realpath "$1")
quick=$(realpath "$2")
cd "$(dirname "${BASH_SOURCE[0]}")"
again=$(mktemp -d)
trap 'rm -rf "$again"' EXIT
python3 -B make.py "$again"
diff -rq -x 'large--*' -x '*.py' -x '*.sh' -x __pycache__ "$again" . || {
  echo "the files are not what make.py writes: run proofs/mutants/make.py proofs/mutants" >&2
  exit 1
}
failures=0
for file in "$again"/*.cert; do
  IFS= read -r expected <"$file"
  expected=${expected:2}
  # However large a file is, it gets no more than 200 MB here, and 10 s of a processor.
  found=$(ulimit -v 200000 -t 10 && "$program" "$file") && code=0 || code=$?
  case "$expected" in
    verified*) wanted=0 ;;
    rejected*) wanted=1 ;;
    *) wanted=3 ;;
  esac
  if [ "$code" -ne "$wanted" ] || [[ "$found" != "$expected"* ]]; then
    echo "$file: expected '$expected', exit $wanted; found '$found', exit $code" >&2
    failures=$((failures + 1))
  fi
done
# The quick check is content with a good mesh by itself, and not with a bad one.
content() {  # what is expected of a certificate
  local found
  found=$("$quick" "$2")
  [ "$found" = "$1" ] || { echo "quick-test $2: expected '$1', found '$found'" >&2; failures=$((failures + 1)); }
}
content "8 of 8, content" sound--space.cert
# Where an apex is on a circumball, integers tell.
content "6 of 6, content" canonical--cube.cert
content "1 of 2, not content" facet-locally-delaunay--space.cert
content "6 of 8, not content" facet-matched--wrong-neighbour.cert
content "13 of 14, not content" sample-outside--doubly-winding-fan-in-space.cert
content "4 of 4, content" sound--plane.cert
content "2 of 2, content" canonical--sound.cert
content "1 of 2, not content" facet-locally-delaunay--plane.cert
content "6 of 7, not content" sample-outside--doubly-winding-fan-in-the-plane.cert
# Words have room for 58 of their 270 digits.
content "2 of 2, content" sound--by-a-unit.cert
content "1 of 2, not content" facet-locally-delaunay--by-a-unit.cert
# The example of Definitions.v, as it stands there.
sed -n '/^<<$/,/^>>$/p' ../Definitions.v | sed '1d;$d' >"$again/triangle"
found=$("$program" "$again/triangle") || true
[ "$found" = "verified: delaunay, 3 points, 1 triangle" ] || {
  echo "the triangle of Definitions.v: found '$found'" >&2
  failures=$((failures + 1))
}
# Only around the mesh of a domain may a point be nobody's.
sed 's/  7$/  -/' "$again/triangle" >"$again/nobodys"
found=$("$program" "$again/nobodys") || true
[[ "$found" == "malformed: $again/nobodys:4: expected an integer, found '-'" ]] || {
  echo "the triangle with a point that is nobody's: found '$found'" >&2
  failures=$((failures + 1))
}
# A file that nobody can read says nothing, as one that is malformed.
found=$("$program" "$again/absent") && code=0 || code=$?
[[ "$found" == "malformed: cannot read $again/absent: "* && "$code" -eq 3 ]] || {
  echo "a file that is not there: expected 'malformed: cannot read ..', exit 3; found '$found', exit $code" >&2
  failures=$((failures + 1))
}
# The same triangle as its user's own files, and as files of other meshes.
cd "$again"
users() {  # what is expected, then options, MESH.node and MESH.ele
  local expected=$1 found
  shift
  found=$("$program" triangle "$@") || true
  if [[ "$found" != $expected ]]; then
    echo "circumspect-verified triangle $*: expected '$expected', found '$found'" >&2
    failures=$((failures + 1))
  fi
}
printf '3 2 1 1\n7 0 0 9 1\n8 1 0 9 1 # a comment\n9 0 5e-1 9 1\n' >own.node
printf '1 3\n1 9 7 8\n' >own.ele
users "verified: delaunay, 3 points, 1 triangle: own.node own.ele" own.node own.ele
sed 's/5e-1/1\/2/' own.node >fraction.node
users "verified*" fraction.node own.ele
sed 's/5e-1/0.50000000000000001/' own.node >nearest.node
users "verified*" nearest.node own.ele
users "rejected: another mesh, nearest.node:4: *coordinate 2 of point 9" --coordinates decimal nearest.node own.ele
users "verified*" --coordinates decimal own.node own.ele
# The coordinates are halves of integers: these are none, and the last is too large to be doubled.
sed 's/5e-1/+.5/' own.node >plain.node
users "verified*" plain.node own.ele
for number in 0.75 .75 -.5 1e308; do
  sed "s/5e-1/$number/" own.node >half.node
  users "rejected: another mesh, half.node:4: *coordinate 2 of point 9" half.node own.ele
done
for number in 0.5.0 . + 0_5; do
  sed "s/5e-1/$number/" own.node >half.node
  users "malformed: half.node:4: expected a decimal or a fraction, found '$number'" half.node own.ele
done
sed 's/^8 1 0/8 1 1/' own.node >moved.node
users "rejected: another mesh, moved.node:3: *coordinate 2 of point 8" moved.node own.ele
sed 's/^7/10/;s/^8/11/;s/^9/12/' own.node >index.node
users "rejected: another mesh, index.node:2: found point 10, *" index.node own.ele
# Rows are numbered in their order, and columns that nothing is about are numbers, as
# docs/formats.md says.
sed 's/^8/7/' own.node >twice.node
users "malformed: twice.node:3: expected the index 8, one more than the line before, found 7" twice.node own.ele
sed '2{h;d};3{p;x}' own.node >order.node
users "malformed: order.node:3: expected the index 9, one more than the line before, found 7" order.node own.ele
sed 's/^8 1 0 9/8 1 0 red/' own.node >attribute.node
users "malformed: attribute.node:3: expected a decimal or a fraction, found 'red'" attribute.node own.ele
sed '3s/9 1 #/9 red #/' own.node >marker.node
users "malformed: marker.node:3: expected an integer, found 'red'" marker.node own.ele
sed '1s/1 1$/1 2/;s/9 1$/9 1 1/;s/9 1 #/9 1 1 #/' own.node >markers.node
users "malformed: markers.node:1: expected 0 or 1 markers, found 2" markers.node own.ele
printf '1 3 1\n1 9 7 8 red\n' >attribute.ele
users "malformed: attribute.ele:2: expected a decimal or a fraction, found 'red'" own.node attribute.ele
printf '1 3\nred 9 7 8\n' >index.ele
users "malformed: index.ele:2: expected an integer, found 'red'" own.node index.ele
sed '1s/3/2/;4d' own.node >fewer.node
users "rejected: another mesh, fewer.node:*expected 3 points, found 2" fewer.node own.ele
sed '1s/3/4/' own.node >cut.node
users "malformed: cut.node:*" cut.node own.ele
sed 's/5e-1/5e/' own.node >number.node
users "malformed: number.node:4: expected a decimal or a fraction, found '5e'" number.node own.ele
sed 's/9 7 8/9 7 7/' own.ele >other.ele
users "rejected: another mesh, other.ele:2: found another simplex 1" own.node other.ele
printf '2 3\n1 9 7 8\n2 9 7 8\n' >more.ele
users "rejected: another mesh, more.ele:3: found more simplices than 1" own.node more.ele
printf '0 3\n' >none.ele
users "rejected: another mesh, none.ele:1: expected 1 simplices, found 0" own.node none.ele
users "malformed: cannot read absent.ele*" own.node absent.ele
# A domain in the plane and one in space, as files of their users.
domain() {  # what is expected, then options, MESH.node, MESH.ele and DOMAIN.poly
  local expected=$1 found
  shift
  found=$("$program" "$certificate" "$@") || true
  if [[ "$found" != $expected ]]; then
    echo "circumspect-verified $certificate $*: expected '$expected', found '$found'" >&2
    failures=$((failures + 1))
  fi
}
varied() {  # what is expected, a line of sed, and the file: held against the same mesh
  sed "$2" "$3" >"varied-$3"
  [ "$(cat "$3")" != "$(cat "varied-$3")" ]
  domain "$1" "${3%.poly}.node" "${3%.poly}.ele" "varied-$3"
}
certificate=sound--domain-in-the-plane.cert
printf '9 2 0 0\n0 0 0\n1 4 2\n2 8 0\n3 8 8\n4 0 8\n5 3 4\n6 5 4\n7 4 6\n8 4 8\n' >plane.node
printf '9 3 0\n0 0 1 5\n1 1 6 5\n2 1 2 6\n3 2 3 6\n4 3 7 6\n5 3 8 7\n6 8 4 7\n7 4 5 7\n8 4 0 5\n' >plane.ele
cat >plane.poly <<'END'
8 2 0 1  # other indices; and vertex 8 of the mesh is none of the domain
1 0 0 0
2 4 2 0
3 8 0 0
4 8 8 0
5 0 8 0
6 3 4 0
7 5 4 0
8 4 6 0
9 0
1 1 2
2 2 3
3 4 3
4 5 4
5 5 1
6 6 7
7 7 8
8 8 6
9 6 8  # listed again
1
1 4 9/2
END
domain "verified: steiner-triangulation, 9 points*, 1 hole: plane.node plane.ele plane.poly" plane.node plane.ele plane.poly
domain "verified*" --coordinates decimal plane.node plane.ele plane.poly
sed -n '1,9p' plane.poly >elsewhere.node
sed -e '2,9d' -e '1s/^8/0/' plane.poly >elsewhere.poly
domain "verified*: plane.node plane.ele elsewhere.poly elsewhere.node" plane.node plane.ele elsewhere.poly
varied "rejected: another domain, varied-plane.poly:2: found the vertex (0 1/2), which is none*" 's/^1 0 0/1 0 0.5/' plane.poly
varied "rejected: another domain, varied-plane.poly:*: found the vertex (3 4) twice" 's/^7 5 4/7 3 4/' plane.poly
varied "rejected: another domain, varied-plane.poly:*: expected 8 vertices, found 7" \
  -e\ '1s/8/7/;/^8 4 6/d;/^[789] [678] [678]/d;s/^9 0/6 0/' plane.poly
varied "rejected: another domain, varied-plane.poly:11: found the segment from (0 0) to (8 0), which is none*" 's/^1 1 2/1 1 3/' plane.poly
varied "rejected: another domain, varied-plane.poly:*: expected the segment from (3 4) to (4 6), found none" \
  's/^9 0/7 0/;/^[89] [68] [68]/d' plane.poly
varied "rejected: another domain, varied-plane.poly:21: found the hole point (4 5), which is none*" 's/9\/2/5/' plane.poly
varied "rejected: another domain, varied-plane.poly:*: expected the hole point (4 9/2), found none" \
  's/^1$/0/;/9\/2/d' plane.poly
# Options may give the domain hole points that its file does not list.
domain "verified*: plane.node plane.ele varied-plane.poly --hole 4,9/2" --hole 4,9/2 plane.node plane.ele varied-plane.poly
domain "rejected: another domain, varied-plane.poly:0: found the hole point (4 5), which is none*" --hole 4,9/2 --hole 4,5 plane.node plane.ele varied-plane.poly
domain "rejected: another domain, varied-plane.poly:*: expected the hole point (4 9/2), found none" --hole 99,0 plane.node plane.ele varied-plane.poly
domain "" --hole 4,9/2,x plane.poly 2>/dev/null
varied "verified*" '$s/$/\n2 9 9/;s/^1$/2/' plane.poly  # a hole point beyond all the mesh makes no hole
varied "malformed: varied-plane.poly:11: expected a vertex of the file, found '12'" 's/^1 1 2/1 1 12/' plane.poly
varied "malformed: varied-plane.poly:*: expected the end of the file, found 'and'" '$s/$/\n0\nand more/' plane.poly
varied "malformed: varied-plane.poly:4: expected the index 3, one more than the line before, found 4" 's/^3 8 0/4 8 0/' plane.poly
varied "malformed: varied-plane.poly:2: expected an integer, found 'red'" 's/^1 0 0 0/1 0 0 red/' plane.poly
varied "malformed: varied-plane.poly:11: expected an integer, found 'red'" 's/^1 1 2/red 1 2/' plane.poly
varied "malformed: varied-plane.poly:*: expected 4 or 5 columns, found 3" '$s/$/\n1\n1 2 2/' plane.poly
# What MESH.face and MESH.edge list is read for certificates, too: each is a face of a simplex; the
# line names what was read.
printf '2 1\n0 0 1 1\n1 2 3 0\n' >plane.edge
domain "verified: steiner-triangulation, *: plane.node plane.ele plane.edge plane.poly" plane.node plane.ele plane.poly
printf '2 1\n0 0 1 1\n1 0 3 0\n' >plane.edge
domain "rejected: another mesh, plane.edge:3: found a triangle or an edge that is a face of no simplex, and does not dangle" plane.node plane.ele plane.poly
printf '1 1\n0 0 1 red\n' >plane.edge
domain "malformed: plane.edge:2: expected an integer, found 'red'" plane.node plane.ele plane.poly
printf '2 0\n0 0 1 7\n1 2 3\n' >plane.edge
domain "malformed: plane.edge:3: expected 4 columns, found 3" plane.node plane.ele plane.poly
rm plane.edge
domain "malformed: cannot read absent.poly*" plane.node plane.ele absent.poly
# An edge that dangles is in MESH.edge; what is listed there and dangles is in the certificate.
certificate=complex.overlap--shown--dangling.cert
printf '7 2\n0 0 0\n1 2 0\n2 2 2\n3 0 2\n4 1 1/2\n5 1 1\n6 1/2 3/2\n' >dangling.node
printf '1 3\n0 0 1 2\n' >dangling.ele
printf '3 1\n0 0 1 1\n1 6 1 0\n2 6 1 -1\n' >dangling.edge
domain "verified: not steiner-cdt, complex.overlap; 1 dangling face; *: dangling.node dangling.ele dangling.edge" dangling.node dangling.ele
found=$(sed '/^dangling/{n;s/^2 /0 /}' "$certificate" | "$program" -) || true
[[ "$found" == "malformed: -:"*": expected 1 to 2 vertices, and points that make them a simplex, found '0'" ]] || {
  echo "$certificate with a face without vertices: found '$found'" >&2
  failures=$((failures + 1))
}
[[ "$("$program" --mesh "$certificate")" == *'"faces": ['?'[6, 1]]}' ]] || {
  echo "$certificate: --mesh leaves out what dangles" >&2
  failures=$((failures + 1))
}
sed 's/^0 0 1/0 0 3/' dangling.edge >other.edge
cp other.edge dangling.edge
domain "rejected: another mesh, dangling.edge:2: found a triangle or an edge that is a face of no simplex*" dangling.node dangling.ele
printf '1 0\n0 0 1\n' >dangling.edge
domain "rejected: another mesh, dangling.edge:0: expected a dangling triangle or edge that is not listed" dangling.node dangling.ele
printf '1 0\n0 0 9\n' >dangling.edge
domain "rejected: another mesh, dangling.edge:2: found a point that the certificate does not list" dangling.node dangling.ele
rm dangling.edge
domain "rejected: another mesh, dangling.ele:0: expected a dangling triangle or edge that is not listed" dangling.node dangling.ele
# What a lattice repeats: offsets are attributes of the simplices, and the line has the lattice.
certificate=periodic--square.cert
printf '1 2 0\n7 .5 1\n' >periodic.node
printf '2 3 6\n0 7 7 7 0 0 1 0 1 1\n1 7 7 7 0 0 1 1 0 1\n' >periodic.ele
domain "verified: periodic-delaunay, 1 point, 2 triangles; lattice: 2,0,0,2: periodic.node periodic.ele" periodic.node periodic.ele
sed 's/^0 7 7 7 0 0 1 0/0 7 7 7 0 0 1 1/' periodic.ele >offset.ele
domain "rejected: another mesh, offset.ele:2: found another attribute 4 of simplex 1" periodic.node offset.ele
printf '2 3\n0 7 7 7\n1 7 7 7\n' >offset.ele
domain "rejected: another mesh, offset.ele:2: expected 6 attributes of simplex 1, found 0" periodic.node offset.ele
# The hull of points in the plane may be listed as its vertices, each the first of an edge to the
# next. The edges of a mesh may not.
certificate=convex-hull--plane.cert
printf '6 2 0\n0 0 0\n1 6 0\n2 6 6\n3 0 6\n4 4 1\n5 3 0\n' >hull.node
printf '4 2\n0 0 1\n1 2 1\n2 2 3\n3 3 0\n' >hull.ele
printf '4 1\n0 0\n1 1\n2 2\n3 3\n' >cycle.ele
domain "verified: convex-hull, 6 points, 4 edges: hull.node hull.ele" hull.node hull.ele
domain "verified: convex-hull, 6 points, 4 edges: hull.node cycle.ele" hull.node cycle.ele
printf '4 1\n0 0\n1 2\n2 1\n3 3\n' >star.ele
domain "rejected: another mesh, star.ele:5: found another simplex 1" hull.node star.ele
printf '3 1\n0 0\n1 1\n2 2\n' >path.ele
domain "rejected: another mesh, path.ele:4: found another simplex 3" hull.node path.ele
certificate=line--plane.cert
printf '2 2 0\n0 0 5/2\n1 1 5/2\n' >edge.node
printf '2 1\n0 0\n1 1\n' >ends.ele
domain "rejected: another mesh, ends.ele:2: found another simplex 1" edge.node ends.ele
certificate=triangle
domain "rejected: another domain, plane.poly: the certificate is about none" own.node own.ele plane.poly
certificate=sound--domain-in-space.cert
printf '5 3 0 0\n0 8 0 0\n1 0 8 0\n2 0 0 8\n3 2 2 2\n4 0 0 0\n' >space.node
printf '3 4 0\n0 4 0 1 3\n1 4 0 2 3\n2 4 1 2 3\n' >space.ele
cat >space.poly <<'END'
5 3 0 0
0 8 0 0
1 0 8 0
2 0 0 8
3 2 2 2
4 0 0 0
7 1
1 0 1
3 4
  0 1
1 0 1
4 4 0 0 2  # a corner that repeats the one before it
1 0
3 4 1 2
1 0
3 1 0 3
1 0
3 0 2 3
1 0
3 1 2 3
2 0  # no polygon: two segments
2 0 4
2 4 1
0
END
domain "verified: plc-triangulation, 5 points*6 polygons: space.node space.ele space.poly" space.node space.ele space.poly
varied "rejected: another domain, varied-space.poly:21: found a polygon that is none*" 's/^2 0  #.*/3 0/;s/^2 4 1/2 4 1\n2 1 0/' space.poly
varied "rejected: another domain, varied-space.poly:*: expected 6 polygons, found 5" 's/^7 1/6 1/;8,10d' space.poly
varied "rejected: another domain, varied-space.poly:*: expected the segment from (0 0 8) to (2 2 2), found none" \
  's/^7 1/5 1/;19,20d;17,18d' space.poly
varied "rejected: another domain, varied-space.poly:8: found a polygon with other holes" '8s/1 0/1 1/;s/^  0 1/  0 1\n1 1 1 0/' space.poly
varied "malformed: varied-space.poly:*" '$d;21,$d' space.poly
varied "malformed: varied-space.poly:8: expected 'POLYGONS \[HOLES \[MARKER\]\]', found other numbers" '8s/^1/-1/' space.poly
# A refutation says which vertices and segments the domain has.
certificate=domain.segment-missing--shown.cert
printf '7 2\n0 0 0\n1 2 0\n2 2 2\n3 0 2\n4 1 .5\n5 1 1\n6 .5 1.5\n' >refuted.node
printf '4 3\n0 0 1 4\n1 1 2 4\n2 2 3 4\n3 3 0 4\n' >refuted.ele
printf '4 2\n0 0 0\n1 2 0\n2 2 2\n3 0 2\n5\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n4 0 2\n0\n' >refuted.poly
domain "verified: not cdt, domain.segment-missing; domain: 4 vertices, 5 segments: refuted.node refuted.ele refuted.poly" \
  refuted.node refuted.ele refuted.poly
varied "rejected: another domain, varied-refuted.poly:11: found the segment from (2 0) to (0 2), which is none*" 's/^4 0 2/4 1 3/' refuted.poly
varied "rejected: another domain, varied-refuted.poly:*: expected the segment from (0 0) to (2 2), found none" 's/^5$/4/;/^4 0 2/d' refuted.poly
varied "rejected: another domain, varied-refuted.poly:5: found the vertex (0 3), which is none*" 's/^3 0 2/3 0 3/' refuted.poly
# What shows that a domain has no triangulation is about the domain alone.
certificate=sound--impossible.cert
printf '8 3\n0 1 0 0\n1 -1 0 0\n2 0 1 0\n3 0 -1 0\n4 0 0 1\n5 0 0 -1\n6 1.5 1.5 1.5\n7 2 .5 .5\n2\n1\n2 0 1\n1\n2 2 3\n0\n' >octahedron.poly
domain "verified: no triangulation*, 8 vertices, 2 segments: octahedron.poly" octahedron.poly
sed 's/^2 2 3/2 2 4/' octahedron.poly >other.poly
domain "rejected: another domain, other.poly:14: found the segment from (0 1 0) to (0 0 1), which is none*" other.poly
sed 's/^7 2 /7 3 /' octahedron.poly >moved.poly
domain "rejected: another domain, moved.poly:9: found the vertex (3 1/2 1/2), which is none*" --coordinates decimal moved.poly
[ "$failures" -eq 0 ]
cd - >/dev/null
# Every condition of the checker has a mutant.
sed -n 's/^| `\([a-z-]*\)` |.*/\1/p' ../CERTIFICATE.md | while read -r condition; do
  ls "$condition"*.cert >/dev/null 2>&1 || { echo "no mutant breaks $condition" >&2; exit 1; }
done
echo "mutants: $(ls "$again"/*.cert | wc -l) certificates and refutations answered as expected"
