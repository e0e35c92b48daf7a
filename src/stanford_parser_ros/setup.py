"""Installed by catkin only."""

from distutils.core import setup

from catkin_pkg.python_setup import generate_distutils_setup

setup(**generate_distutils_setup(packages=["stanford_parser_ros", "stanford_parser_ros.lean"], package_dir={"": "src"}))
