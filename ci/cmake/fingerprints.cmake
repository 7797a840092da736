# Writes the table of what the program is made of: the hash of the object of each source, whether the source has a header of
# its own, and which folder of the catalog includes which. Results carry hashes of it, so that they are taken again only where no code
# that could change them has changed. Called with -DLIST (a file with the objects' paths), -DSOURCE and -DOUTPUT.
file(STRINGS ${LIST} objects)
list(FILTER objects EXCLUDE REGEX "/cmake_pch[^/]*$")
list(SORT objects)
set(lines "")
foreach(object IN LISTS objects)
  if(NOT object MATCHES "((kernel|reference|cases)/CMakeFiles/[^/]+\\.dir)/(.*)\\.(o|obj)$")
    message(FATAL_ERROR "${object}: of no known part")
  endif()
  string(REPLACE "/./" "/" source "${CMAKE_MATCH_2}/${CMAKE_MATCH_3}")
  if(source STREQUAL "cases/harness/results/provenance.cpp")
    continue()  # holds the commit, which changes no number
  endif()
  file(SHA256 ${object} hash)
  string(SUBSTRING ${hash} 0 16 hash)
  set(sources ${source})
  if(source MATCHES "/Unity/")  # one object of several sources
    string(REGEX REPLACE "\\.(o|obj)$" "" unit "${object}")
    file(STRINGS ${unit} sources REGEX "^#include \"")
    list(TRANSFORM sources REPLACE "^#include \"${SOURCE}/(.*)\"$" "\\1")
  endif()
  foreach(source IN LISTS sources)
    string(REGEX REPLACE "\\.cpp$" ".hpp" header "${SOURCE}/${source}")
    set(has_header false)
    if(EXISTS "${header}")
      set(has_header true)
    endif()
    string(APPEND lines "    {\"${source}\", \"${hash}\", ${has_header}},\n")
  endforeach()
endforeach()

set(uses "")
file(GLOB files ${SOURCE}/cases/catalog/*/*.cpp ${SOURCE}/cases/catalog/*/*.hpp)
foreach(file IN LISTS files)
  string(REGEX REPLACE ".*/catalog/([^/]+)/[^/]+$" "\\1" folder "${file}")
  file(STRINGS "${file}" includes REGEX "^#include \"cases/catalog/[^/\"]+/")
  foreach(include IN LISTS includes)
    string(REGEX REPLACE "^#include \"cases/catalog/([^/]+)/.*" "\\1" used "${include}")
    list(APPEND uses "    {\"${folder}\", \"${used}\"},\n")
  endforeach()
endforeach()
list(REMOVE_DUPLICATES uses)
list(SORT uses)
list(JOIN uses "" uses)

file(CONFIGURE OUTPUT ${OUTPUT} CONTENT [[// Made by the build.
#include "cases/harness/results/fingerprint.hpp"

namespace plumbline {
namespace {

const RegisterCode of_this_program{{
@lines@  }, {
@uses@  }};

}  // namespace
}  // namespace plumbline
]] @ONLY)
