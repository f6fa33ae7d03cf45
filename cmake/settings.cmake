# How every file is compiled: the language, the warnings, and arithmetic that means what it says.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

if(PROJECT_IS_TOP_LEVEL AND NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE RelWithDebInfo CACHE STRING "Build type" FORCE)
endif()

# Options that let a compiler change the value of an expression have no place in an exact oracle.
# A project around this one may have set them for its folders.
string(TOUPPER "${CMAKE_BUILD_TYPE}" _build_type)
get_directory_property(_options_around COMPILE_OPTIONS)
get_directory_property(_definitions_around COMPILE_DEFINITIONS)
set(_flags "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${_build_type}} ${_options_around}")
if(_flags MATCHES "(-Ofast|-ffast-math|-funsafe-math-optimizations|-fassociative-math|-freciprocal-math|-ffinite-math-only|-ffp-contract=(on|fast))")
  message(FATAL_ERROR
    "The compiler flags contain ${CMAKE_MATCH_1}, which changes the results of floating-point "
    "arithmetic. Remove it from CMAKE_CXX_FLAGS (or CXXFLAGS, or add_compile_options) and configure again.")
endif()

find_program(CIRCUMSPECT_CCACHE ccache DOC "Compiler cache; used when found")
mark_as_advanced(CIRCUMSPECT_CCACHE)
if(CIRCUMSPECT_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${CIRCUMSPECT_CCACHE}")
  if(CIRCUMSPECT_QUICK_BUILD)
    # Without these liberties it does not cache what is compiled with a precompiled header.
    set(CMAKE_CXX_COMPILER_LAUNCHER "${CMAKE_COMMAND}" -E env
        CCACHE_SLOPPINESS=pch_defines,time_macros "${CIRCUMSPECT_CCACHE}")
  endif()
endif()

# The tests of GCC's quick build are compiled by Clang, if there is one.
find_program(CIRCUMSPECT_CLANG clang++ DOC "Compiles tests in less time than GCC; used when found")
mark_as_advanced(CIRCUMSPECT_CLANG)
if(CIRCUMSPECT_QUICK_BUILD AND CIRCUMSPECT_CLANG AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  set(CIRCUMSPECT_TEST_LAUNCHER "${PROJECT_SOURCE_DIR}/cmake/by_clang.sh")
  if(CIRCUMSPECT_CCACHE)
    set(CIRCUMSPECT_TEST_LAUNCHER "${CMAKE_COMMAND}" -E env
        CCACHE_SLOPPINESS=pch_defines,time_macros "${PROJECT_SOURCE_DIR}/cmake/by_clang.sh" "${CIRCUMSPECT_CCACHE}")
  endif()
endif()

find_program(CIRCUMSPECT_MOLD mold DOC "A faster linker for tests; used when found")
mark_as_advanced(CIRCUMSPECT_MOLD)

# Everything the project compiles links `circumspect_settings`. Headers are included by their path
# from the root of the repository, the public ones as users do: <circumspect/...>. Warnings become
# errors in the presets, not for a packager; a project around this one gets none, since they are not
# its own.
add_library(circumspect_settings INTERFACE)
target_include_directories(circumspect_settings INTERFACE
  "${PROJECT_SOURCE_DIR}" "${PROJECT_SOURCE_DIR}/include")
target_compile_options(circumspect_settings INTERFACE -ffp-contract=off)  # the filters' bounds are proved for that
if(MINGW)
  # GCC aligns wide vectors on a stack that Windows aligns less (GCC bug 54412): the assembler is to
  # move them as if they were anywhere.
  target_compile_options(circumspect_settings INTERFACE -Wa,-muse-unaligned-vector-move -Wa,-mbig-obj)  # and many sections
  # Of a function that several sources have, the linker keeps one copy. GCC takes its own for that
  # copy there, and leaves values in registers that the other one needs.
  target_compile_options(circumspect_settings INTERFACE -fno-ipa-ra)
  # A constant that does not fit a long, which has 32 bits there, would become another number.
  target_compile_options(circumspect_settings INTERFACE -Werror=overflow)
endif()
if(PROJECT_IS_TOP_LEVEL)
  target_compile_options(circumspect_settings INTERFACE
    -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual)
endif()
# Assertions stay on, whatever the build type: a broken invariant must not turn into an answer.
if(CMAKE_CONFIGURATION_TYPES OR "${_flags} ${_definitions_around}" MATCHES "NDEBUG")
  target_compile_options(circumspect_settings INTERFACE -UNDEBUG)
endif()

# The standard library's assertions end a test at an index beyond an end. The sanitizers' build
# looks only at what handles bytes, arrays and processes.
if(CIRCUMSPECT_QUICK_BUILD AND CIRCUMSPECT_BUILD_TESTS)
  target_compile_definitions(circumspect_settings INTERFACE _GLIBCXX_ASSERTIONS)
endif()

if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CIRCUMSPECT_QUICK_BUILD)
  # It spends a twentieth of its time on collecting garbage, of which a source leaves half a
  # gigabyte.
  target_compile_options(circumspect_settings INTERFACE "SHELL:--param ggc-min-heapsize=1048576")
  # Line numbers for a debugger take it another twentieth. Who wants them uses the presets as they
  # are.
  target_compile_options(circumspect_settings INTERFACE $<$<CONFIG:RelWithDebInfo>:-g0>)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # GCC 12 sees an overlapping copy in `"text" + std::string` where there is none (GCC bug 105651).
  target_compile_options(circumspect_settings INTERFACE -Wno-restrict)
endif()
if((CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 13) OR
   (CMAKE_CXX_COMPILER_ID STREQUAL "Clang" AND CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 15))
  # Later compilers than those that the project is developed with warn of other things, such as GCC
  # 14 of an std::optional in a moved struct that it takes for uninitialized: nobody's build ends
  # for that.
  set(CMAKE_COMPILE_WARNING_AS_ERROR OFF)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_FLAGS MATCHES "-fsanitize=")
  # GCC's own documentation: sanitizers make this warning fire on sound code.
  target_compile_options(circumspect_settings INTERFACE -Wno-maybe-uninitialized)
endif()
if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  # Clang counts sign conversions among -Wconversion, GCC does not; hold both to the same rule.
  # Among them it also counts `assert(!"why this cannot be")`.
  target_compile_options(circumspect_settings INTERFACE
    -Wno-sign-conversion -Wno-string-conversion)
  # A precompiled header is then the same file whenever it is made, as ccache needs it.
  target_compile_options(circumspect_settings INTERFACE "SHELL:-Xclang -fno-pch-timestamp")
endif()
