"""Installed by catkin only."""

from distutils.core import setup

from catkin_pkg.python_setup import generate_distutils_setup

setup(**generate_distutils_setup(packages=["stop_server"], package_dir={"": "src"}))
