# Settings shared by all targets. Targets link `plumbline_options` privately.
include(GNUInstallDirs)
option(PLUMBLINE_BUILD_TESTS "Build the tests" ON)
option(PLUMBLINE_WERROR "Treat warnings as errors" ON)
set(PLUMBLINE_SANITIZE "" CACHE STRING "Value for -fsanitize=, empty for none")
set(PLUMBLINE_ARCH "auto" CACHE STRING "Value for -march=; auto: x86-64-v3 where this machine runs it, else the compiler's default")

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_CXX_FLAGS_RELEASE "-O3 -DNDEBUG")

# A second build of the same sources, in whatever folder, takes seconds.
find_program(PLUMBLINE_CCACHE ccache)
if(PLUMBLINE_CCACHE AND NOT DEFINED CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${PLUMBLINE_CCACHE}")
endif()
if(CMAKE_CXX_COMPILER_LAUNCHER MATCHES "ccache$")  # which keeps what is made with precompiled headers only if told so
  list(PREPEND CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros)
endif()

# Headers of libraries that most sources of a target include take longer to read than the sources themselves. Every source still
# names what it uses: builds with another compiler than GCC read the headers one by one.
function(plumbline_precompile target)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_precompile_headers(${target} PRIVATE <algorithm> <cmath> <filesystem> <functional> <map> <memory> <optional>
      <sstream> <stdexcept> <string> <vector> ${ARGN})
    target_compile_options(${target} PRIVATE -fpch-preprocess)  # ccache then knows what such headers hold
  endif()
endfunction()

# The same headers as of a target with the same options and definitions, compiled there.
function(plumbline_precompiled_by target other)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_precompile_headers(${target} REUSE_FROM ${other})
    target_compile_options(${target} PRIVATE -fpch-preprocess)
  endif()
endfunction()

# What GCC keeps in memory before it looks for what it no longer needs: a twelfth of a compilation is that search otherwise.
add_compile_options($<$<COMPILE_LANG_AND_ID:CXX,GNU>:--param=ggc-min-heapsize=1048576>)

# Reading headers, and what each file makes of their templates, is most of a compilation: sixteen sources are one translation
# unit, or as many as are said, so that their unnamed namespaces are one as well. OFF compiles each alone, for work on a few of them.
option(PLUMBLINE_UNITY "Compile many sources of a target as one" ON)
function(plumbline_unite target)
  set(size ${ARGN})
  if(NOT size)
    set(size 16)
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${PLUMBLINE_UNITY} UNITY_BUILD_BATCH_SIZE ${size})
  # GCC takes a part of such a unit for a header, whose classes may hold nothing of an unnamed namespace.
  target_compile_options(${target} PRIVATE $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-Wno-subobject-linkage>)
endfunction()

# A text of JSON as literals, which a source includes; `output` is to be among the sources of its target.
function(plumbline_literals file output)
  cmake_path(GET file FILENAME name)
  add_custom_command(OUTPUT ${output} COMMENT "Taking in ${name}"
    COMMAND ${CMAKE_COMMAND} -DFILE=${file} -DOUTPUT=${output} -P ${PROJECT_SOURCE_DIR}/ci/cmake/literals.cmake
    DEPENDS ${file} ${PROJECT_SOURCE_DIR}/ci/cmake/literals.cmake VERBATIM)
endfunction()

# Cases know their file by name; where the sources stand must not show in what the compiler makes of them. A ccache with
# a base folder sees to that itself, and would take the option for another program.
if(PLUMBLINE_CCACHE)
  execute_process(COMMAND ${PLUMBLINE_CCACHE} -k base_dir OUTPUT_VARIABLE PLUMBLINE_CCACHE_BASE
    OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endif()
if(NOT PLUMBLINE_CCACHE_BASE)
  add_compile_options(-fmacro-prefix-map=${PROJECT_SOURCE_DIR}/=)
endif()

if(PLUMBLINE_ARCH STREQUAL "auto")
  include(CheckCXXSourceRuns)
  set(CMAKE_REQUIRED_FLAGS "-march=x86-64-v3 -O1")
  check_cxx_source_runs("
    int main() { return __builtin_cpu_supports(\"avx2\") && __builtin_cpu_supports(\"fma\") ? 0 : 1; }"
    PLUMBLINE_RUNS_X86_64_V3)
  unset(CMAKE_REQUIRED_FLAGS)
endif()

add_library(plumbline_options INTERFACE)
target_compile_features(plumbline_options INTERFACE cxx_std_20)
# No contraction into fused operations: the same sums give the same bits under every instruction set.
target_compile_options(plumbline_options INTERFACE -ffp-contract=off -Wall -Wextra -Wpedantic -Wshadow
  -Wnon-virtual-dtor -Woverloaded-virtual)
# GCC 12 sees overlapping copies in "text" + string (its bug 105651).
target_compile_options(plumbline_options INTERFACE $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-Wno-restrict>)
if(PLUMBLINE_WERROR)
  target_compile_options(plumbline_options INTERFACE -Werror)
endif()
if(PLUMBLINE_ARCH STREQUAL "auto")
  if(PLUMBLINE_RUNS_X86_64_V3)
    target_compile_options(plumbline_options INTERFACE -march=x86-64-v3)
  endif()
elseif(PLUMBLINE_ARCH)
  target_compile_options(plumbline_options INTERFACE -march=${PLUMBLINE_ARCH})
endif()
if(PLUMBLINE_SANITIZE)
  # A finding ends the program: otherwise a test that provokes undefined behaviour stays green.
  target_compile_options(plumbline_options INTERFACE -fsanitize=${PLUMBLINE_SANITIZE} -fno-sanitize-recover=all
    -fno-omit-frame-pointer)
  target_link_options(plumbline_options INTERFACE -fsanitize=${PLUMBLINE_SANITIZE})
endif()
