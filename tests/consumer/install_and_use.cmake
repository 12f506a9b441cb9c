# Installs the build in BUILD into a fresh folder under WORK, moves it, builds tests/consumer/project against it and
# runs the program. Called by CTest with SOURCE, COMPILER and CONFIGURATION.
file(REMOVE_RECURSE ${WORK})
set(prefix ${WORK}/moved)
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/installed OUTPUT_QUIET
                COMMAND_ERROR_IS_FATAL ANY)
# A package must work wherever it is carried, and without the tree it came from.
file(RENAME ${WORK}/installed ${prefix})
file(GLOB_RECURSE texts ${prefix}/*.cmake ${prefix}/*.hpp ${prefix}/*.inl)
foreach(text IN LISTS texts)
  file(READ ${text} content)
  foreach(folder ${SOURCE} ${BUILD} ${WORK})
    string(FIND "${content}" "${folder}/" at)
    if(NOT at EQUAL -1)
      message(SEND_ERROR "${text} names ${folder}")
    endif()
  endforeach()
endforeach()

execute_process(
  COMMAND ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/project -B ${WORK}/build -G Ninja
          -D CMAKE_PREFIX_PATH=${prefix} -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_BUILD_TYPE=${CONFIGURATION}
  COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${WORK}/build COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${WORK}/build/noon OUTPUT_VARIABLE said COMMAND_ERROR_IS_FATAL ANY)
message("The consumer said: ${said}")
# The Sun's altitude on the meridian of Greenwich at the June solstice: 90 - 51.477 + 23.436 degrees.
if(NOT said MATCHES "Sun: 61\\.9[56]")
  message(FATAL_ERROR "The consumer should have found the Sun at 61.96 degrees")
endif()

# The sky of the default medium comes with the programs: none has to make it, wherever they are carried.
file(GLOB tables ${BUILD}/share/vesper/*.tables)
if(tables AND EXISTS ${prefix}/bin/vesper-report)
  execute_process(
    COMMAND ${CMAKE_COMMAND} -E env XDG_CACHE_HOME=${WORK}/cache ${prefix}/bin/vesper-report --time 2026-06-21T12:00:00Z
            --columns horizontal_illuminance_lux
    OUTPUT_VARIABLE said COMMAND_ERROR_IS_FATAL ANY)
  message("The installed program said: ${said}")
  if(NOT said MATCHES "horizontal_illuminance_lux = 10[0-9][0-9][0-9][0-9]\\.")
    message(FATAL_ERROR "At noon in June level ground at Greenwich should have some 103 klx")
  endif()
  if(EXISTS ${WORK}/cache)
    message(FATAL_ERROR "The installed program made tables that it should have found")
  endif()
endif()
