# vesper_embed(TARGET SYMBOL FILE... [BASE DIR])
# Compiles the files into TARGET as a table of byte arrays that vesper/base/embedded.hpp reads:
# `extern const vesper::EmbeddedTable SYMBOL;` (in namespace vesper). Names are relative to BASE.
function(vesper_embed target symbol)
  cmake_parse_arguments(ARG "" "BASE" "" ${ARGN})
  set(output ${CMAKE_CURRENT_BINARY_DIR}/${symbol}.cpp)
  list(JOIN ARG_UNPARSED_ARGUMENTS "|" joined)
  add_custom_command(
    OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -D SYMBOL=${symbol} -D OUTPUT=${output} -D BASE=${ARG_BASE} -D "FILES=${joined}"
            -P ${PROJECT_SOURCE_DIR}/cmake/embed.cmake
    DEPENDS ${ARG_UNPARSED_ARGUMENTS} ${PROJECT_SOURCE_DIR}/cmake/embed.cmake
    COMMENT "Embedding ${symbol}"
    VERBATIM)
  target_sources(${target} PRIVATE ${output})
endfunction()

# vesper_digest(TARGET SYMBOL FILE...)
# Compiles a digest of the files' contents into TARGET: `extern const std::string_view SYMBOL;` (in namespace vesper).
function(vesper_digest target symbol)
  set(output ${CMAKE_CURRENT_BINARY_DIR}/${symbol}.cpp)
  list(JOIN ARGN "|" joined)
  add_custom_command(
    OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -D SYMBOL=${symbol} -D OUTPUT=${output} -D "FILES=${joined}" -P
            ${PROJECT_SOURCE_DIR}/cmake/digest.cmake
    DEPENDS ${ARGN} ${PROJECT_SOURCE_DIR}/cmake/digest.cmake
    COMMENT "Digest ${symbol}"
    VERBATIM)
  target_sources(${target} PRIVATE ${output})
endfunction()
