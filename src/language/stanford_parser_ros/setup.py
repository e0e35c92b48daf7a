"""Installed by catkin only."""

from distutils.core import setup

from catkin_pkg.python_setup import generate_distutils_setup

PACKAGES = ["stanford_parser_ros", "stanford_parser_ros.joint", "stanford_parser_ros.words"]
setup(**generate_distutils_setup(packages=PACKAGES, package_dir={"": "src"}))
