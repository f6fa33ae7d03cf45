#!/bin/bash
# What is different on Windows: ends of lines, names of files, 32 bits of `long`, wide vectors on
# the stack, and what needs Linux.
#   cmake/windows_test.sh COMMAND FOLDER
# COMMAND runs the command for Windows. FOLDER is made anew.
set -euo pipefail

command=$(realpath "${1:?usage: cmake/windows_test.sh COMMAND FOLDER}")
folder=${2:?usage: cmake/windows_test.sh COMMAND FOLDER}
chazelle=$(cd "$(dirname "${BASH_SOURCE[0]}")/../corpus/domains" && pwd)/figure-4-13-chazelle-3.poly
rm -rf "$folder"
mkdir -p "$folder/größe"
cd "$folder"

fail() {
  echo "windows_test: $1" >&2
  exit 1
}

# says CODE TEXT ARGUMENT…: the exit code, and a text somewhere in what is printed, without CR
says() {
  local code=$1 text=$2 found=0
  shift 2
  "$command" "$@" >out 2>&1 </dev/null || found=$?
  [ "$found" = "$code" ] || fail "expected exit code $code of $*, found $found: $(cat out)"
  grep -qF -- "$text" out || fail "expected \"$text\" of $*, found $(cat out)"
  ! grep -q $'\r' out || fail "expected no carriage return of $*"
}

# A square, cut along the wrong diagonal; the names have a letter that is not ASCII.
printf '4 2 0 0\n1 0 0\n2 1 0\n3 0 1\n4 0.9 0.9\n' >größe/x.1.node
printf '2 3 0\n1 1 2 3\n2 2 4 3\n' >größe/x.1.ele
says 1 "größe\\x.1.ele" check 'größe\x.1.ele'
cp out with-lf
sed -i 's/$/\r/' größe/x.1.node größe/x.1.ele
says 1 "" check 'größe\x.1.ele'
cmp -s out with-lf || fail "expected the same of lines that end in CR LF, found $(cat out)"
says 1 "" check --format json 'größe/x.1.ele'
says 3 "no file of that name" check 'größe\y.1.ele'
says 3 "a directory" check größe

# Files are replaced, whole, and have the bytes that they have elsewhere.
says 0 "" build delaunay 'größe\x.1.node' -o 'größe\made.ele'
says 0 "" build delaunay 'größe\x.1.node' -o 'größe\made.ele'
says 0 "" check 'größe\made.ele'
says 1 "differ: 0 points 2 simplices" compare 'größe\x.1.ele' 'größe\made.ele'
says 0 "holds: delaunay" certify 'größe\made.ele' -o 'größe\certificate'
grep -qx "circumspect-certificate 1 delaunay 2 unique" größe/certificate || fail "expected a certificate, found $(cat größe/certificate)"
! grep -q $'\r' größe/{made.ele,certificate} || fail "expected no carriage return in a file"
[ -z "$(find . -name '.unfinished-*')" ] || fail "expected no unfinished files"
says 2 "is the same file" build delaunay 'größe\x.1.node' -o './größe/x.1.node'

# Numbers that a `long` of 32 bits does not hold.
printf '2 3 1\n1 1 2 3 3000000000\n2 2 4 3 5\n' >größe/x.1.ele
says 0 "3 points 1 triangle" check 'größe\x.1.ele' --keep-label 3000000000
printf '2 3\n1 -1 2 -1\n2 1099511627776 -1 -1\n' >größe/x.1.neigh
says 1 "neighbour listed: 1099511627776" check 'größe\x.1.ele' --neighbors

# So many points that the fast judge takes them in blocks, by wide vectors.
says 0 "" generate uniform --seed 1 --points 20000 -o large.node
says 0 "" build delaunay large.node -o large.ele
says 0 "20000 points" check large.ele

# The thread that looks on ends long work.
says 4 "undecided: inspect stopped by --limit" inspect "$chazelle" --limit 1s

# What needs Linux says so.
says 2 "expected Linux" campaign --dimension 2 -- program
says 2 "expected Linux" minimize finding
says 2 "expected Linux" check --memory 500M größe/made.ele
echo "windows_test: ends of lines, names, numbers, vectors and refusals are as expected"
