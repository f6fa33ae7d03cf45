#!/bin/sh
# Compiles a test by Clang, which takes three fifths of GCC's time when neither optimizes. CMake
# calls it as the launcher of GCC (cmake/layers.cmake):
#   cmake/by_clang.sh [CCACHE] COMPILER ARGUMENT...
cache=
case ${1##*/} in ccache*) cache=$1; shift ;; esac
shift
# An argument of this name is a precompiled header that is to be made: Clang would read what is
# there before.
for argument; do
  case $argument in *.gch) rm -f "$argument" ;; esac
done
# Clang knows GCC's arguments but for a few, which it is not to complain of. The last one has a
# precompiled header instantiate its templates once for all.
exec $cache clang++ "$@" -Wno-unknown-warning-option -Wno-unused-command-line-argument -Wno-sign-conversion \
  -Wno-string-conversion -Xclang -fno-pch-timestamp -fpch-instantiate-templates
