# The libraries of others. All are Debian 12 packages: `cmake/packages.sh` lists them.

# A project around this one links them through circumspect::harness, so it has to see them.
if(NOT PROJECT_IS_TOP_LEVEL)
  set(CMAKE_FIND_PACKAGE_TARGETS_GLOBAL ON)
endif()

# find_package, unless the project around this one has the target already.
macro(circumspect_find_package package target)
  if(NOT TARGET ${target})
    find_package(${package} REQUIRED)
  endif()
endmacro()

# For one file that runs on any Linux: archives instead of libraries. Debian has none of {fmt},
# whose headers do, and none of oneTBB, whose place plain threads take
# (oracle/judge/fast/in_chunks.cpp).
if(CIRCUMSPECT_STATIC)
  set(CMAKE_FIND_LIBRARY_SUFFIXES .a)
  add_library(fmt::fmt INTERFACE IMPORTED GLOBAL)
  target_compile_definitions(fmt::fmt INTERFACE FMT_HEADER_ONLY)
  # Archives are searched in the order in which they stand: CGAL names GMP before MPFR, which needs
  # it behind.
  string(APPEND CMAKE_CXX_STANDARD_LIBRARIES " -lgmp")
endif()

# In a browser, and on Windows as cmake/windows.cmake compiles for it: headers and archives of all
# are in one folder, which command/web/libraries.sh or cmake/windows_libraries.sh has made.
set(libraries "${CIRCUMSPECT_WEB_LIBRARIES}${CIRCUMSPECT_WINDOWS_LIBRARIES}")
if(libraries)
  include_directories(SYSTEM "${libraries}/include")
  foreach(package fmt::fmt nlohmann_json::nlohmann_json CLI11::CLI11 CGAL::CGAL)
    add_library(${package} INTERFACE IMPORTED GLOBAL)
  endforeach()
  target_compile_definitions(fmt::fmt INTERFACE FMT_HEADER_ONLY)
  file(STRINGS "${libraries}/include/CGAL/version.h" CGAL_VERSION REGEX "define CGAL_VERSION ")
  string(REGEX REPLACE ".*CGAL_VERSION +" "" CGAL_VERSION "${CGAL_VERSION}")
  list(PREPEND CMAKE_PREFIX_PATH "${libraries}")
  set(CMAKE_FIND_LIBRARY_SUFFIXES .a)
endif()
# What the standard library of the browser lacks is in a header that stands before every file.
if(EMSCRIPTEN)
  add_library(Threads::Threads INTERFACE IMPORTED GLOBAL)
  # WebAssembly always rounds to nearest, so no interval of CGAL's may be used, and none is: its
  # kernel here computes with rationals alone. What it tries at the start of a program would end the
  # program.
  target_compile_definitions(CGAL::CGAL INTERFACE CGAL_DISABLE_ROUNDING_MATH_CHECK)
  # A page is fetched more often than it waits for an answer: small code before fast code, but in
  # the fast judge.
  target_compile_options(circumspect_settings INTERFACE
                         "$<IF:$<IN_LIST:$<TARGET_PROPERTY:NAME>,circumspect_fast;circumspect_fast_predicates>,-O2,-Oz>" -fwasm-exceptions
                         "SHELL:-include ${PROJECT_SOURCE_DIR}/command/web/libcxx.hpp")
  set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE NEVER)
  set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY NEVER)
endif()

# circumspect_find_library(NAME HEADER [LIBRARY...] DEBIAN PACKAGE)
# makes the target circumspect::NAME.
function(circumspect_find_library name header)
  cmake_parse_arguments(ARG "" "DEBIAN" "" ${ARGN})
  find_path(CIRCUMSPECT_${name}_INCLUDE "${header}")
  mark_as_advanced(CIRCUMSPECT_${name}_INCLUDE)
  set(files)
  foreach(library IN LISTS ARG_UNPARSED_ARGUMENTS)
    find_library(CIRCUMSPECT_${name}_${library} "${library}")
    mark_as_advanced(CIRCUMSPECT_${name}_${library})
    list(APPEND files "${CIRCUMSPECT_${name}_${library}}")
  endforeach()
  if(NOT CIRCUMSPECT_${name}_INCLUDE OR files MATCHES "NOTFOUND")
    message(FATAL_ERROR "<${header}> or its library was not found: install ${ARG_DEBIAN}, "
                        "or run `make deps`.")
  endif()
  add_library(circumspect::${name} INTERFACE IMPORTED GLOBAL)
  target_include_directories(circumspect::${name} SYSTEM INTERFACE "${CIRCUMSPECT_${name}_INCLUDE}")
  target_link_libraries(circumspect::${name} INTERFACE ${files})
endfunction()

circumspect_find_library(gmp gmpxx.h gmpxx gmp DEBIAN libgmp-dev)
circumspect_find_library(mpfr mpfr.h mpfr DEBIAN libmpfr-dev)
target_link_libraries(circumspect::mpfr INTERFACE circumspect::gmp)  # archives are searched in this order
circumspect_find_library(expected tl/expected.hpp DEBIAN libexpected-dev)
circumspect_find_library(boost boost/geometry/index/rtree.hpp DEBIAN libboost-dev)
circumspect_find_package(fmt fmt::fmt)
circumspect_find_package(nlohmann_json nlohmann_json::nlohmann_json)
circumspect_find_package(Threads Threads::Threads)
# Only what reads files needs them.
if(circumspect_reads_files)
  circumspect_find_library(pugixml pugixml.hpp pugixml DEBIAN libpugixml-dev)
  circumspect_find_library(zlib zlib.h z DEBIAN zlib1g-dev)
endif()

# circumspect_find_optional(NAME DEFINITION HEADER LIBRARY DEBIAN PACKAGE WITHOUT text)
# makes the target circumspect::NAME. It is empty, which CMake says, where the library is not there
# and under -DDEFINITION=OFF: what needs it is then refused when it is met.
function(circumspect_find_optional name definition header library)
  cmake_parse_arguments(ARG "" "DEBIAN;WITHOUT" "" ${ARGN})
  option(${definition} "Read what ${library} packed (needs ${ARG_DEBIAN})" ON)
  add_library(circumspect::${name} INTERFACE IMPORTED GLOBAL)
  if(NOT EMSCRIPTEN)  # it would find the libraries of this machine
    find_path(CIRCUMSPECT_${name}_INCLUDE "${header}")
    find_library(CIRCUMSPECT_${name}_LIBRARY "${library}")
    mark_as_advanced(CIRCUMSPECT_${name}_INCLUDE CIRCUMSPECT_${name}_LIBRARY)
  endif()
  if(${definition} AND CIRCUMSPECT_${name}_INCLUDE AND CIRCUMSPECT_${name}_LIBRARY)
    target_include_directories(circumspect::${name} SYSTEM INTERFACE "${CIRCUMSPECT_${name}_INCLUDE}")
    target_compile_definitions(circumspect::${name} INTERFACE ${definition})
    target_link_libraries(circumspect::${name} INTERFACE "${CIRCUMSPECT_${name}_LIBRARY}")
  else()
    message(STATUS "${ARG_WITHOUT} (without ${ARG_DEBIAN})")
  endif()
endfunction()

if(circumspect_reads_files)
  circumspect_find_optional(zstd CIRCUMSPECT_ZSTD zstd.h zstd DEBIAN libzstd-dev
                            WITHOUT "Files that zstd packed are not read")
  circumspect_find_optional(lzma CIRCUMSPECT_LZMA lzma.h lzma DEBIAN liblzma-dev
                            WITHOUT "Arrays that LZMA packed in .vtu files are not read")
endif()

# Its place can be taken by threads of our own, which share out the work a little worse.
option(CIRCUMSPECT_PLAIN_THREADS "Judge without oneTBB, as is done where there is none" OFF)
if(NOT CIRCUMSPECT_PLAIN_THREADS AND NOT CIRCUMSPECT_STATIC AND NOT libraries AND NOT TARGET TBB::tbb)
  find_package(TBB QUIET)
endif()
add_library(circumspect::parallel INTERFACE IMPORTED GLOBAL)
set(circumspect_links_tbb OFF)
if(TARGET TBB::tbb AND NOT CIRCUMSPECT_PLAIN_THREADS)
  set(circumspect_links_tbb ON)
  target_link_libraries(circumspect::parallel INTERFACE TBB::tbb)
else()
  message(STATUS "Large meshes are judged on plain threads, without oneTBB")
  target_compile_definitions(circumspect::parallel INTERFACE CIRCUMSPECT_PLAIN_THREADS)
endif()
set(CGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE TRUE)
circumspect_find_package(CGAL CGAL::CGAL)

if(CIRCUMSPECT_BUILD_COMMAND)
  circumspect_find_library(cadical cadical.hpp cadical DEBIAN libcadical-dev)
  circumspect_find_package(CLI11 CLI11::CLI11)
endif()

if(CIRCUMSPECT_BUILD_MPI)
  set(MPI_CXX_SKIP_MPICXX ON)  # the functions of C alone
  find_package(MPI REQUIRED COMPONENTS CXX)
endif()

if(CIRCUMSPECT_BUILD_TESTS OR CIRCUMSPECT_BUILD_PYTHON)
  # Debian's Python has the Debian packages; another one that stands before it in PATH has not.
  if(NOT DEFINED Python3_EXECUTABLE AND EXISTS /usr/bin/python3)
    set(Python3_EXECUTABLE /usr/bin/python3 CACHE FILEPATH "The Python that the module is built for")
  endif()
  find_package(Python3 REQUIRED COMPONENTS Interpreter Development.Module)
endif()

if(CIRCUMSPECT_BUILD_TESTS)
  circumspect_find_package(doctest doctest::doctest)
  circumspect_find_package(rapidcheck rapidcheck)
  circumspect_find_library(tetgen tetgen.h tet DEBIAN libtet1.5-dev)
  circumspect_find_library(qhull libqhull_r/qhull_ra.h qhull_r DEBIAN libqhull-dev)
endif()
