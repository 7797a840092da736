# What `ctest -T Test` and `ctest -T Submit` need: numbers and pictures of the cases reach a CDash server where one is named.
set(PLUMBLINE_CDASH_URL "" CACHE STRING "Where ctest -T Submit sends results: https://SERVER/submit.php?project=NAME")
set(SUBMIT_URL "${PLUMBLINE_CDASH_URL}")
set(NIGHTLY_START_TIME "00:00:00 UTC")
cmake_path(GET PROJECT_BINARY_DIR FILENAME preset)
set(BUILDNAME "${preset}-${CMAKE_CXX_COMPILER_ID}-${CMAKE_CXX_COMPILER_VERSION}" CACHE STRING "Name of the build on the server")
# Targets like NightlyMemCheck would be the longest list in this build.
set_property(GLOBAL PROPERTY CTEST_TARGETS_ADDED 1)
include(CTest)
