# Programs and tests of the RoboFrameNet packages.

# roboframenet_pin_interpreter(<script>... [DESTINATION <folder>])
#
# Give scripts that catkin_install_python() installs the interpreter of the build. catkin leaves
# "#!/usr/bin/env python3" as it is in the install space, where the first python3 on the PATH need not be the one
# that ROS belongs to. The destination is that of catkin_install_python(); by default that of the package's programs.
function(roboframenet_pin_interpreter)
  cmake_parse_arguments(ARG "" "DESTINATION" "" ${ARGN})
  if(NOT ARG_DESTINATION)
    set(ARG_DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
  endif()
  foreach(script ${ARG_UNPARSED_ARGUMENTS})
    get_filename_component(name ${script} NAME)
    file(READ ${CMAKE_CURRENT_SOURCE_DIR}/${script} text)
    string(REGEX REPLACE "^#![^\n]*" "#!${PYTHON_EXECUTABLE}" text "${text}")
    set(pinned ${CMAKE_CURRENT_BINARY_DIR}/pinned_scripts/${name})
    file(WRITE ${pinned} "${text}")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${script})
    # Two files of one second are the same to install(): the one of catkin_install_python has to go first.
    install(CODE "file(REMOVE \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${ARG_DESTINATION}/${name}\")")
    install(PROGRAMS ${pinned} DESTINATION ${ARG_DESTINATION})
  endforeach()
endfunction()

# roboframenet_add_tests([FOLDER <folder>] [GRAPHS])
#
# Add the tests of a package, in three tiers (scripts/test runs one). The folder is "test".
#
#   <folder>/unit                 pytest; the marks "acceptance" and "reliability" tell what is of another tier than "test"
#   <folder>/rostest/*.test       rostest, tier "test"; its nodes wait more than they work, unless GRAPHS is given
#   <folder>/acceptance/*.test    rostest, tier "acceptance"
#   <folder>/reliability/*.test   rostest, tier "reliability"
function(roboframenet_add_tests)
  if(NOT CATKIN_ENABLE_TESTING)
    return()
  endif()
  cmake_parse_arguments(ARG "GRAPHS" "FOLDER" "" ${ARGN})
  if(NOT ARG_FOLDER)
    set(ARG_FOLDER test)
  endif()
  file(GLOB unit CONFIGURE_DEPENDS LIST_DIRECTORIES TRUE ${ARG_FOLDER}/unit)
  if(unit)
    roboframenet_add_pytest(unit ${unit})
  endif()
  foreach(tier rostest acceptance reliability)
    file(GLOB rostests CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} ${ARG_FOLDER}/${tier}/*.test)
    if(rostests)
      find_package(rostest REQUIRED)
      get_property(before DIRECTORY PROPERTY TESTS)
      foreach(rostest ${rostests})
        add_rostest(${rostest})
      endforeach()
      _roboframenet_label_tests(${tier} ${before})
      if(NOT ARG_GRAPHS)
        get_property(tests DIRECTORY PROPERTY TESTS)
        if(before)
          list(REMOVE_ITEM tests ${before})
        endif()
        set_tests_properties(${tests} PROPERTIES PROCESSORS 1 COST 1)
      endif()
    endif()
  endforeach()
endfunction()

# roboframenet_add_pytest(<name> <folder>)
#
# Run the tests below a folder with pytest, in every tier: pytest chooses by their marks.
function(roboframenet_add_pytest name folder)
  set(results ${CATKIN_TEST_RESULTS_DIR}/${PROJECT_NAME}/pytest-${name}.xml)
  get_property(before DIRECTORY PROPERTY TESTS)
  catkin_run_tests_target("pytest" ${name} "pytest-${name}.xml"
    COMMAND "\"${PYTHON_EXECUTABLE}\" -m pytest -q -p no:cacheprovider --junitxml=${results} ${folder}")
  _roboframenet_label_tests(pytest ${before})
endfunction()

# roboframenet_check_launch_files(<path>)
#
# Check launch files with roslaunch: nodes and included files exist, and package.xml names their packages. As
# roslaunch_add_file_check(), with the interpreter of the build.
function(roboframenet_check_launch_files path)
  find_package(roslaunch REQUIRED)
  set(folder ${CATKIN_TEST_RESULTS_DIR}/${PROJECT_NAME})
  set(results roslaunch-check_${path}.xml)
  get_property(before DIRECTORY PROPERTY TESTS)
  catkin_run_tests_target("roslaunch-check" ${path} ${results}
    COMMAND "${CMAKE_COMMAND} -E make_directory ${folder}"
            "\"${PYTHON_EXECUTABLE}\" ${roslaunch_check_script} -i -o ${folder}/${results} ${CMAKE_CURRENT_SOURCE_DIR}/${path}")
  _roboframenet_label_tests(rostest ${before})
endfunction()

# _roboframenet_label_tests(<label> [<test>...])
#
# Label the tests of this folder that are not among the given ones; scripts/test chooses by labels, and runs two jobs on each
# core. A test counts as two unless it says otherwise; what takes longest begins first.
function(_roboframenet_label_tests label)
  get_property(tests DIRECTORY PROPERTY TESTS)
  if(ARGN)
    list(REMOVE_ITEM tests ${ARGN})
  endif()
  if(tests)
    set_tests_properties(${tests} PROPERTIES LABELS ${label} PROCESSORS 2 COST 2)
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
