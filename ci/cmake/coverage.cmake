# What the tests reach (ci/coverage): counts in the parts that are judged, and nowhere else.
option(PLUMBLINE_COVERAGE "Count which lines of kernel, reference and harness run" OFF)
if(PLUMBLINE_COVERAGE)
  foreach(part kernel reference harness)
    # Counters that threads share may lose a count, never all: whether a line runs is all that is asked, and atomic ones take
    # several times as long.
    target_compile_options(plumbline_${part} PRIVATE --coverage -fprofile-update=single)
  endforeach()
  target_link_options(plumbline_options INTERFACE --coverage)
endif()
