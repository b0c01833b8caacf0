# The types for programs in other languages, in targets of their own that the normal build never asks for:
#   lcmtypes_jar      <build>/lcmtypes/lcmtypes.jar, for Java and lcm-spy
#   lcmtypes_python   <build>/lcmtypes/python/<package>/, modules that need nothing but Python 3

# lcmtypes_elsewhere(files...): the two targets, from these .lcm files.
function(lcmtypes_elsewhere)
  lcmtypes_jar(${ARGN})
  lcmtypes_python(${ARGN})
endfunction()

function(lcmtypes_jar)
  find_program(JAVAC javac)
  find_program(JAR jar)
  find_file(LCM_JAR lcm.jar PATHS /usr/share/java /usr/local/share/java)
  if(NOT JAVAC OR NOT JAR OR NOT LCM_JAR)
    add_custom_target(lcmtypes_jar
      COMMAND "${CMAKE_COMMAND}" -E echo "lcmtypes_jar needs javac, jar and lcm.jar: launch/install spy, then configure again"
      COMMAND "${CMAKE_COMMAND}" -E false
      VERBATIM)
    return()
  endif()
  set(jar "${CMAKE_CURRENT_BINARY_DIR}/lcmtypes.jar")
  set(work "${CMAKE_CURRENT_BINARY_DIR}/java")
  add_custom_command(
    OUTPUT "${jar}"
    COMMAND "${CMAKE_COMMAND}" -E rm -rf "${work}"
    COMMAND "${LCM_GEN}" --java --jpath "${work}/sources" ${ARGN}
    COMMAND sh -c "'${JAVAC}' -nowarn -d '${work}/classes' -cp '${LCM_JAR}' $(find '${work}/sources' -name '*.java')"
    COMMAND "${JAR}" cf "${jar}" -C "${work}/classes" .
    DEPENDS ${ARGN} "${LCM_JAR}"
    COMMENT "Types for Java"
    VERBATIM)
  add_custom_target(lcmtypes_jar DEPENDS "${jar}")
endfunction()

function(lcmtypes_python)
  set(modules "${CMAKE_CURRENT_BINARY_DIR}/python")
  add_custom_command(
    OUTPUT "${modules}.made"
    COMMAND "${CMAKE_COMMAND}" -E rm -rf "${modules}"  # lcm-gen adds to an __init__.py that it finds.
    COMMAND "${LCM_GEN}" --python --ppath "${modules}" ${ARGN}
    COMMAND "${CMAKE_COMMAND}" -E touch "${modules}.made"
    DEPENDS ${ARGN}
    COMMENT "Types for Python"
    VERBATIM)
  add_custom_target(lcmtypes_python DEPENDS "${modules}.made")
endfunction()
