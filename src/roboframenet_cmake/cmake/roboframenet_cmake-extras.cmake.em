# Programs and tests of the RoboFrameNet packages.

# roboframenet_pin_interpreter(<script>...)
#
# Give scripts that catkin_install_python() installs the interpreter of the build. catkin leaves
# "#!/usr/bin/env python3" as it is in the install space, where the first python3 on the PATH need not be the one
# that ROS belongs to.
function(roboframenet_pin_interpreter)
  foreach(script ${ARGN})
    get_filename_component(name ${script} NAME)
    file(READ ${CMAKE_CURRENT_SOURCE_DIR}/${script} text)
    string(REGEX REPLACE "^#![^\n]*" "#!${PYTHON_EXECUTABLE}" text "${text}")
    set(pinned ${CMAKE_CURRENT_BINARY_DIR}/pinned_scripts/${name})
    file(WRITE ${pinned} "${text}")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${script})
    # Two files of one second are the same to install(): the one of catkin_install_python has to go first.
    install(CODE "file(REMOVE \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CATKIN_PACKAGE_BIN_DESTINATION}/${name}\")")
    install(PROGRAMS ${pinned} DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
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

# roboframenet_underlay_is_needed(<result>)
#
# Tell whether a package of this name has to be built here: FALSE when another one is installed outside this
# workspace. Packages that only stand in for those of other distributions ask before they build anything.
function(roboframenet_underlay_is_needed result)
  set(prefixes ${CMAKE_PREFIX_PATH} ${CMAKE_SYSTEM_PREFIX_PATH})
  file(TO_CMAKE_PATH "$ENV{CMAKE_PREFIX_PATH}" from_environment)
  list(APPEND prefixes ${from_environment})
  set(folders)
  foreach(prefix ${prefixes})
    if(NOT prefix STREQUAL CATKIN_DEVEL_PREFIX AND NOT prefix STREQUAL CMAKE_INSTALL_PREFIX)
      list(APPEND folders ${prefix}/share/${PROJECT_NAME})
    endif()
  endforeach()
  file(TO_CMAKE_PATH "$ENV{ROS_PACKAGE_PATH}" package_path)
  foreach(folder ${package_path})
    if(NOT folder STREQUAL "${CMAKE_INSTALL_PREFIX}/share")
      list(APPEND folders ${folder}/${PROJECT_NAME})
    endif()
  endforeach()
  set(${result} TRUE PARENT_SCOPE)
  foreach(folder ${folders})
    if(EXISTS ${folder}/package.xml)
      # A copy of our own, built before into a folder that is now another prefix, is no reason to leave it out.
      file(READ ${folder}/package.xml manifest)
      if(NOT manifest MATCHES "maintainers@@roboframenet.example")
        message(STATUS "${PROJECT_NAME}: not built, the one in ${folder} is used")
        set(${result} FALSE PARENT_SCOPE)
        return()
      endif()
    endif()
  endforeach()
endfunction()
