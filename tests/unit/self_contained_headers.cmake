# Every header of every floor compiles alone, with no more than what its floor promises to whoever links it.
# A header that forgets an include, or leans on a private dependency, breaks the build here.
get_property(floors GLOBAL PROPERTY VESPER_INSTALLED_TARGETS)
foreach(floor IN LISTS floors)
  get_target_property(type ${floor} TYPE)
  if(type STREQUAL "INTERFACE_LIBRARY")
    continue()
  endif()
  get_target_property(folder ${floor} SOURCE_DIR)
  get_target_property(name ${floor} EXPORT_NAME)
  file(GLOB headers CONFIGURE_DEPENDS RELATIVE ${folder} ${folder}/*.hpp)
  set(sources "")
  foreach(header IN LISTS headers)
    string(REPLACE ".hpp" ".cpp" source ${CMAKE_CURRENT_BINARY_DIR}/headers/${name}/${header})
    # Twice, so that a missing #pragma once shows too.
    file(CONFIGURE OUTPUT ${source}
         CONTENT "#include \"vesper/@name@/@header@\"\n#include \"vesper/@name@/@header@\"\n" @ONLY)
    list(APPEND sources ${source})
  endforeach()
  if(sources)
    add_library(vesper_headers_${name} OBJECT ${sources})
    target_link_libraries(vesper_headers_${name} PRIVATE ${floor})
    vesper_compile_options(vesper_headers_${name})
    # Only to see that they compile.
    target_compile_options(vesper_headers_${name} PRIVATE $<$<CXX_COMPILER_ID:GNU,Clang>:-O0>)
  endif()
endforeach()
