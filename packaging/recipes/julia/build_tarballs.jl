# BinaryBuilder, for Yggdrasil: the C library, which examples/julia/Circumspect.jl calls.
using BinaryBuilder

name = "circumspect"
version = v"@VERSION@"
sources = [
    ArchiveSource("https://github.com/circumspect/circumspect/releases/download/v@VERSION@/circumspect-@VERSION@-source.tar.gz",
                  "@SHA256@"),
    GitSource("https://github.com/TartanLlama/expected.git", "292eff8bd8ee230a7df1d6a1c00c4ea0eb2f0362"), # 1.1.0, one header
]
script = raw"""
cd ${WORKSPACE}/srcdir/circumspect-*
cmake -S . -B build -G Ninja -DCMAKE_INSTALL_PREFIX=${prefix} -DCMAKE_TOOLCHAIN_FILE=${CMAKE_TARGET_TOOLCHAIN} \
    -DCMAKE_BUILD_TYPE=Release -DCIRCUMSPECT_expected_INCLUDE=${WORKSPACE}/srcdir/expected/include \
    -DCIRCUMSPECT_QUICK_BUILD=ON -DCIRCUMSPECT_BUILD_TESTS=OFF -DCIRCUMSPECT_BUILD_COMMAND=OFF
cmake --build build --parallel ${nproc} --target circumspect_archive
cmake --install build --component harness
install_license LICENSE
"""
platforms = expand_cxxstring_abis([Platform("x86_64", "linux"; libc = "glibc"), Platform("aarch64", "linux"; libc = "glibc")])
products = [LibraryProduct("libcircumspect", :libcircumspect)]
dependencies = [
    Dependency("GMP_jll"),
    Dependency("MPFR_jll"),
    Dependency("Fmt_jll"),
    BuildDependency("boost_jll"),
    BuildDependency("CGAL_jll"),
    BuildDependency("nlohmann_json_jll"),
]
build_tarballs(ARGS, name, version, sources, script, platforms, products, dependencies; julia_compat = "1.6",
               preferred_gcc_version = v"12")
