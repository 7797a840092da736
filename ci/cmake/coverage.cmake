# What the tests reach (ci/coverage): counts in the parts that are judged, and nowhere else.
option(PLUMBLINE_COVERAGE "Count which lines of kernel, reference and harness run" OFF)
if(PLUMBLINE_COVERAGE)
  foreach(part kernel reference harness)
    # Runs share the counters between threads.
    target_compile_options(plumbline_${part} PRIVATE --coverage -fprofile-update=atomic)
  endforeach()
  target_link_options(plumbline_options INTERFACE --coverage)
endif()
