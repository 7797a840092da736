# What the tests reach (ci/coverage): counts in the parts that are judged, and nowhere else.
option(PLUMBLINE_COVERAGE "Count which lines of kernel, reference and harness run" OFF)
if(PLUMBLINE_COVERAGE)
  foreach(part kernel loops reference harness)
    # Threads share the counters, and may lose counts: of a line that runs often, so that some remain. Atomic counters, which
    # OpenMP would ask for, lose none, and make tests of the kernel fifty times as long.
    target_compile_options(plumbline_${part} PRIVATE --coverage -fprofile-update=single)
  endforeach()
  target_link_options(plumbline_options INTERFACE --coverage)
endif()
