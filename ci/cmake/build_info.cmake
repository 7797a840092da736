# Writes build_info.hpp; the file is touched only when its text changes, so nothing is rebuilt without need.
set(PLUMBLINE_GIT "")
set(PLUMBLINE_DIRTY false)
# In a source archive git has put its commit here. Such a tree is no checkout, even inside one of another project.
file(STRINGS ${SOURCE}/ci/cmake/archived_commit.txt archived REGEX "^[0-9a-f]+$")
if(archived)
  set(PLUMBLINE_GIT ${archived})
elseif(GIT)
  execute_process(COMMAND ${GIT} -C ${SOURCE} rev-parse HEAD OUTPUT_VARIABLE PLUMBLINE_GIT RESULT_VARIABLE status
    OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(NOT status EQUAL 0)
    set(PLUMBLINE_GIT "")
  endif()
  execute_process(COMMAND ${GIT} -C ${SOURCE} status --porcelain OUTPUT_VARIABLE changes ERROR_QUIET)
  if(changes)
    set(PLUMBLINE_DIRTY true)
  endif()
endif()
configure_file(${TEMPLATE} ${OUTPUT} @ONLY)
