# Programs and tests of the RoboFrameNet packages.

# roboframenet_install_programs(<script>...)
#
# Install Python programs into the package's folder, and make them runnable from the devel space.
# catkin leaves "#!/usr/bin/env python3" as it is in the install space, where the first python3 on the PATH
# need not be the one that ROS belongs to: here the interpreter of the build is written in.
function(roboframenet_install_programs)
  catkin_install_python(PROGRAMS ${ARGN} DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
  foreach(program ${ARGN})
    get_filename_component(name ${program} NAME)
    file(READ ${CMAKE_CURRENT_SOURCE_DIR}/${program} text)
    string(REGEX REPLACE "^#![^\n]*" "#!${PYTHON_EXECUTABLE}" text "${text}")
    set(rewritten ${CMAKE_CURRENT_BINARY_DIR}/roboframenet_programs/${name})
    file(WRITE ${rewritten} "${text}")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${program})
    # A later rule wins over the one of catkin_install_python.
    install(PROGRAMS ${rewritten} DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
  endforeach()
endfunction()

# roboframenet_add_tests([FOLDER <folder>])
#
# Run <folder>/unit with pytest, and every <folder>/rostest/*.test with rostest. The folder is "test".
function(roboframenet_add_tests)
  if(NOT CATKIN_ENABLE_TESTING)
    return()
  endif()
  cmake_parse_arguments(ARG "" "FOLDER" "" ${ARGN})
  if(NOT ARG_FOLDER)
    set(ARG_FOLDER test)
  endif()
  set(unit ${CMAKE_CURRENT_SOURCE_DIR}/${ARG_FOLDER}/unit)
  if(EXISTS ${unit})
    set(results ${CATKIN_TEST_RESULTS_DIR}/${PROJECT_NAME}/pytest-unit.xml)
    catkin_run_tests_target("pytest" "unit" "pytest-unit.xml"
      COMMAND "\"${PYTHON_EXECUTABLE}\" -m pytest -q -p no:cacheprovider --junitxml=${results} ${unit}")
  endif()
  file(GLOB rostests CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} ${ARG_FOLDER}/rostest/*.test)
  if(rostests)
    find_package(rostest REQUIRED)
    foreach(rostest ${rostests})
      add_rostest(${rostest})
    endforeach()
  endif()
endfunction()
