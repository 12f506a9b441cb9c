# Targets of the house: one library per floor, warnings and sanitizers everywhere.

set(VESPER_WARNINGS
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wnon-virtual-dtor -Wold-style-cast
    -Wcast-align -Woverloaded-virtual -Wnull-dereference)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # Clang 14 warns of the explicit double{x} too.
  list(APPEND VESPER_WARNINGS -Wdouble-promotion)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # False alarms in std::string's own code (GCC bug 105651).
  list(APPEND VESPER_WARNINGS -Wno-restrict)
endif()
if(VESPER_WARNINGS_AS_ERRORS)
  list(APPEND VESPER_WARNINGS -Werror)
endif()

# The tree's own public headers are included as "vesper/<floor>/<file>.hpp", before and after installation.
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/include/vesper)
file(CREATE_LINK ${PROJECT_SOURCE_DIR}/shaders ${PROJECT_BINARY_DIR}/include/vesper/shaders SYMBOLIC)

function(vesper_compile_options target)
  target_compile_options(${target} PRIVATE $<$<COMPILE_LANGUAGE:CXX>:${VESPER_WARNINGS}>)
  # Contraction would let the same expression round differently in two places of one program.
  target_compile_options(${target} PRIVATE -ffp-contract=off)
  if(VESPER_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=${VESPER_SANITIZE} -fno-omit-frame-pointer
                                             -fno-sanitize-recover=all)
    target_link_options(${target} PUBLIC -fsanitize=${VESPER_SANITIZE})
  endif()
endfunction()

# vesper_add_floor(NAME SOURCES ... [DEPENDS ...] [PRIVATE_DEPENDS ...])
# The library vesper_NAME with the alias vesper::NAME, from the folder this is called in.
function(vesper_add_floor name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS;PRIVATE_DEPENDS" ${ARGN})
  set(target vesper_${name})
  add_library(${target} STATIC ${ARG_SOURCES})
  add_library(vesper::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR} ${PROJECT_BINARY_DIR}/include/vesper/${name} SYMBOLIC)
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include>
                                              $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_link_libraries(${target} PUBLIC ${ARG_DEPENDS} PRIVATE ${ARG_PRIVATE_DEPENDS})
  vesper_compile_options(${target})
  set_property(GLOBAL APPEND PROPERTY VESPER_INSTALLED_TARGETS ${target})
  install(DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/vesper/${name}
          FILES_MATCHING PATTERN "*.hpp" PATTERN "*.inl")
endfunction()
