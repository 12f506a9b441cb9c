# Runs glslangValidator over SHADERS (in FOLDER), once per projection and tier for the stages that use them. WORK takes
# the copies that carry the lines which the library adds at run time: version, includes, defines.
foreach(shader IN LISTS SHADERS)
  file(READ ${shader} text)
  cmake_path(GET shader FILENAME name)
  set(variants "")
  if(text MATCHES "PROJECTION|disc_stage")
    foreach(projection RANGE 4)
      list(APPEND variants "#define PROJECTION ${projection}\n")
      foreach(switch BEYOND CHEAP CONSTANT_COLOR CORONA DISCS ECLIPSE EYE FALSE_COLOR LAMBERT PEAK SHARP)
        if(text MATCHES "${switch}")
          list(APPEND variants "#define PROJECTION ${projection}\n#define ${switch}\n")
        endif()
      endforeach()
    endforeach()
  else()
    list(APPEND variants "\n")
    if(text MATCHES "SMALL")
      list(APPEND variants "#define SMALL\n")
    endif()
    if(text MATCHES "OUTSIDE")
      list(APPEND variants "#define OUTSIDE\n" "#define OUTSIDE\n#define SMALL\n" "#define OUTSIDE\n#define MANY_LIGHTS\n")
    endif()
  endif()
  foreach(variant IN LISTS variants)
    file(WRITE ${WORK}/${name}
         "#version 450 core\n#extension GL_GOOGLE_include_directive : require\n${variant}#line 1\n${text}")
    execute_process(
      COMMAND ${VALIDATOR} -l -I${FOLDER} ${WORK}/${name}
      RESULT_VARIABLE result
      OUTPUT_VARIABLE output
      ERROR_VARIABLE output)
    if(NOT result EQUAL 0)
      message(FATAL_ERROR "${shader} with ${variant}:\n${output}")
    endif()
  endforeach()
endforeach()
